// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats of text whose lines say by their first word what they are.
#include <algorithm>
#include <cstring>

#include "robot/worker/misread_formats.h"

namespace link_bounds {
namespace {

bool startsWith(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

/// The rule of assimp: any other file is a text.
bool isBinaryStl(Lines& lines) {
  constexpr std::size_t kHeader = 80;
  const std::string text = lines.beginning(kHeader + sizeof(std::uint32_t));
  std::uint32_t count = 0;
  if (text.size() < kHeader + sizeof(count)) return false;
  std::memcpy(&count, text.data() + kHeader, sizeof(count));
  return count * 50 + static_cast<std::uint32_t>(text.size()) == lines.fileSize();
}

/// Assimp leaves out a vertex with another count of numbers, or with a number that begins with its
/// decimal point.
constexpr std::array<std::size_t, 3> kNumbersOfObjVertex{3, 4, 6};

std::size_t countObjNumbers(std::string_view text, const std::string& place) {
  Words words(text);
  std::size_t count = 0;
  for (auto word = words.next(); !word.empty() && word[0] != '#'; word = words.next()) {
    requireNumber(word, place);
    if (word[0] == '.' || word[0] == ',')
      throw MeshError("assimp leaves out a vertex with a number that begins with \"" +
                      std::string(1, word[0]) + "\", in " + place + "; write 0 before it");
    ++count;
  }
  return count;
}

/// The first words of lines of OBJ, without kObjSurfaces, and "fo", an old face. Assimp leaves out
/// other lines.
constexpr std::array kObjWords{
    "v",      "vt",    "vn",       "vp",       "p",          "l",         "f",     "fo",
    "g",      "s",     "mg",       "o",        "usemtl",     "mtllib",    "bevel", "lod",
    "curv",   "curv2", "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech", "stech",
    "cstype", "deg",   "bmat",     "step",     "parm",       "trim",      "hole",  "scrv",
    "sp",     "end",   "con",      "maplib",   "usemap",     "csh",       "cdc",   "res"};

/// The first words of lines that add faces without "f": surfaces and other files.
constexpr std::array kObjSurfaces{"surf", "bsp", "bzp", "cdp", "call"};

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Accepts what some exporters write: a byte order mark, comments as in C, or an end of file as DOS
/// has it.
void checkObjWord(std::string_view word, const std::string& place) {
  if (startsWith(word, kByteOrderMark)) {
    word.remove_prefix(kByteOrderMark.size());
    if (word == "v" || word == "f")
      throw MeshError("assimp leaves out " + place +
                      ", because it begins with a byte order mark; remove that");
  }
  if (word.empty() || word[0] == '#' || word == "\x1A" || startsWith(word, "//")) return;
  if (std::find(kObjSurfaces.begin(), kObjSurfaces.end(), word) != kObjSurfaces.end())
    throw MeshError("assimp leaves out the faces of " + inQuotes(word) + ", in " + place +
                    "; export triangles");
  if (std::find(kObjWords.begin(), kObjWords.end(), word) == kObjWords.end())
    throw MeshError(inQuotes(word) + " is no word of OBJ, in " + place);
}

/// Assimp leaves out a corner that it cannot read, and takes +1 for two corners.
void checkObjCorners(std::string_view text, const std::string& place) {
  Words words(text);
  for (auto word = words.next(); !word.empty() && word[0] != '#'; word = words.next()) {
    bool is_corner = word[0] != '/' && word.find_first_not_of("0123456789-/") == word.npos;
    for (std::size_t i = 1; i < word.size(); ++i)
      is_corner &= word[i] != '-' || word[i - 1] == '/';
    if (!is_corner) throw MeshError(inQuotes(word) + " is no corner, in " + place);
  }
}

/// Checks the three numbers after the word "vertex", and returns the word after them.
std::string_view checkStlVertex(Words& words, const std::string& place) {
  for (int i = 0; i < 3; ++i)
    requireNumber(words.next(), place);
  const std::string_view next = words.next();
  if (!next.empty() && isNumber(next))
    throw MeshError("a vertex has more than 3 numbers, in " + place);
  return next;
}

/// Whether assimp leaves out this word of a text STL because of its capital letters.
bool isLostByCapitals(std::string_view word) {
  if (word.size() != 5 && word.size() != 6) return false;
  const std::string small = inSmallLetters(std::string(word));
  return small != word && (small == "facet" || small == "vertex");
}

}  // namespace

/// Checks by words, which may stand in any line. Assimp reads another part only if the line after
/// an "endsolid" begins with "solid".
void checkStl(Lines& lines) {
  if (isBinaryStl(lines)) return;
  bool is_over = false, is_lost = false;
  while (const auto line = lines.next()) {
    Words words(*line);
    std::string_view word = words.next();
    const bool is_part = word == "solid";
    is_lost |= is_over && !is_part;
    for (; is_lost && !word.empty(); word = words.next())
      if (inSmallLetters(std::string(word)) == "vertex")
        throw MeshError("assimp leaves out " + lines.place() +
                        ", because no line \"solid\" follows an \"endsolid\"");
    is_over = is_lost;
    if (is_part) words.next();  // its name
    while (!word.empty() && !is_over) {
      if (!is_part && isLostByCapitals(word))
        throw MeshError("assimp leaves out " + inQuotes(word) + ", in " + lines.place() +
                        "; write it in small letters");
      is_over = startsWith(word, "endsolid");
      word = word == "vertex" ? checkStlVertex(words, lines.place()) : words.next();
    }
  }
}

void checkObj(Lines& lines) {
  lines.keepBlankLines();
  bool goes_on = false, is_data = false, is_vertex = false, is_face = false;
  std::size_t count = 0;
  while (const auto found = lines.next()) {
    std::string_view line = *found;
    const bool is_first = !goes_on;
    goes_on = !line.empty() && line.back() == '\\';
    if (goes_on) line.remove_suffix(1);
    Words words(line);
    const std::string_view first = words.next();
    const bool is_geometry = first == "v" || first == "f";
    if (is_geometry && !is_first && !is_data)
      throw MeshError("assimp leaves out " + lines.place() +
                      ", because the one before it ends in a backslash; remove that");
    if (is_geometry && is_first && (line[0] == ' ' || line[0] == '\t'))
      throw MeshError("assimp leaves out " + lines.place() +
                      ", because it begins with a blank; remove that");
    if (line.find('\0') != line.npos) throw MeshError("a byte 0 is in " + lines.place());
    if (is_first) {
      checkObjWord(first, lines.place());
      is_data = !line.empty() && std::strchr("vflp", line[0]) != nullptr;
      is_vertex = first == "v";
      is_face = first == "f";
      count = 0;
    }
    if (is_face) checkObjCorners(is_first ? line.substr(1) : line, lines.place());
    if (!is_vertex) continue;
    count += countObjNumbers(is_first ? line.substr(1) : line, lines.place());
    const auto& counts = kNumbersOfObjVertex;
    if (!goes_on && std::find(counts.begin(), counts.end(), count) == counts.end())
      throw MeshError("assimp leaves out a vertex of " + std::to_string(count) + " numbers, in " +
                      lines.place() + "; write 3, 4 or 6");
  }
}

}  // namespace link_bounds

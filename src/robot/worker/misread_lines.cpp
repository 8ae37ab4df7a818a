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

bool isSignOrDigit(char c) {
  return ('0' <= c && c <= '9') || c == '-' || c == '+';
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

/// Entities with faces that assimp leaves out.
constexpr std::array kDxfSurfaces{"SOLID", "TRACE", "MESH", "REGION", "3DSOLID", "BODY"};

bool isDxfSurface(std::string_view entity) {
  return entity.find("SURFACE") != entity.npos || startsWith(entity, "ACAD_PROXY") ||
         std::find(kDxfSurfaces.begin(), kDxfSurfaces.end(), entity) != kDxfSurfaces.end();
}

/// Refuses what assimp leaves out: an entity or a section whose name is not in capitals, and
/// entities with faces that it does not know.
void checkDxfName(std::string_view name, bool is_entity, const std::string& place) {
  if (std::any_of(name.begin(), name.end(), [](char c) { return 'a' <= c && c <= 'z'; }))
    throw MeshError("assimp leaves out " + inQuotes(name) + ", in " + place +
                    "; write it in capitals");
  if (is_entity && isDxfSurface(name))
    throw MeshError("assimp leaves out the " + std::string(name) + " in " + place +
                    "; export faces as 3DFACE");
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

/// Also refuses objects and surfaces that are not announced, because assimp leaves them out.
void checkAc3d(Lines& lines) {
  std::size_t objects = 0, announced_objects = 1, surfaces = 0, announced_surfaces = 0;
  std::size_t corners = 0;  // of the current surface that are still to come
  while (const auto line = lines.next()) {
    Words words(*line);
    const std::string_view first = words.next();
    if (corners > 0) requireIndex(first, lines.place());
    if (corners > 0) --corners;
    if (isSignOrDigit(first.front())) requireNumber(first, lines.place());
    if (isSignOrDigit(first.front()) || first == "loc" || first == "rot")
      words.countNumbers(lines.place());
    if (first == "OBJECT") ++objects;
    if (first == "SURF") ++surfaces;
    if (first == "kids") announced_objects += countOf(words.next());
    if (first == "numsurf") announced_surfaces += countOf(words.next());
    if (first == "refs") corners = countOf(words.next());
    if (first == "data") lines.next();
  }
  if (objects > announced_objects || surfaces > announced_surfaces)
    throw MeshError("it has " + std::to_string(objects) + " objects and " +
                    std::to_string(surfaces) + " surfaces, and announces " +
                    std::to_string(announced_objects) + " and " +
                    std::to_string(announced_surfaces) + " by kids and numsurf");
}

/// Refuses a corner beyond the vertices, for which assimp reads the memory behind them.
void checkAse(Lines& lines) {
  std::size_t vertices = 0;
  while (const auto line = lines.next()) {
    std::string text(*line);
    std::replace(text.begin(), text.end(), ':', ' ');
    Words words(text);
    const std::string_view first = words.next();
    if (first == "*MESH_NUMVERTEX") vertices = countOf(words.next());
    if (first == "*MESH_VERTEX" || startsWith(first, "*TM_ROW")) words.countNumbers(lines.place());
    if (first != "*MESH_FACE") continue;
    words.next();  // its number
    for (int i = 0; i < 3; ++i) {
      words.next();  // A, B or C
      const std::string_view corner = words.next();
      requireIndex(corner, lines.place());
      if (countOf(corner) >= vertices)
        throw MeshError("a face names vertex " + std::string(corner) + " of " +
                        std::to_string(vertices) + ", in " + lines.place());
    }
  }
}

/// Each value stands in the line after its group code. Those of 10 to 59 are numbers. 0 begins an
/// entity or a section; the name of a section follows with 2. An INSERT has its columns and rows
/// in 70 and 71.
void checkDxf(Lines& lines) {
  lines.keepBlankLines();
  std::string entity;
  while (const auto line = lines.next()) {
    const std::string_view text = Words(*line).next();
    const std::optional<std::size_t> code =
        text.empty() ? std::nullopt : std::make_optional(countOf(text));
    const auto value = lines.next();
    if (!value || !code) continue;
    const std::string_view word = Words(*value).next();
    if (10 <= *code && *code < 60) requireNumber(word, lines.place());
    const bool is_section = entity == "SECTION" && *code == 2;
    if (*code == 0 || is_section) {
      checkDxfName(word, !is_section, lines.place());
      entity = is_section ? "" : word;
    }
    if (entity == "INSERT" && (*code == 70 || *code == 71) && countOf(word) > 1)
      throw MeshError("assimp leaves out all but the first of an INSERT of rows and columns, in " +
                      lines.place() + "; export faces as 3DFACE");
  }
}

/// A line has 9 numbers, or 12, and then at most the name of a texture. All other lines are names.
void checkRaw(Lines& lines) {
  while (const auto line = lines.next()) {
    Words words(*line);
    std::string_view word = words.next();
    std::size_t numbers = 0, all = 0;
    const bool is_triangle = isSignOrDigit(word.front());
    for (; !word.empty(); word = words.next()) {
      if (numbers == all && numbers < 12 && isSignOrDigit(word.front()) && isNumber(word))
        ++numbers;
      ++all;
    }
    if ((is_triangle || all >= 9) && numbers != 9 && numbers != 12)
      throw MeshError("a triangle has 9 or 12 numbers, not " + std::to_string(numbers) + ", in " +
                      lines.place());
  }
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts lines and corners as assimp's readers take them, one element in each line.
#include "robot/worker/misread_files.h"

#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <vector>

namespace link_bounds {
namespace {

/// Of a text; those of real files take less than 1 KiB.
constexpr std::size_t kMaxHeaderLine = 1 << 16;

/// Assimp leaves out faces with more.
constexpr std::size_t kMostOffCorners = 9;

/// Extensions of glTF that change where vertices are, and that assimp leaves out.
constexpr std::array<const char*, 4> kUnknownToAssimp{
    "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "EXT_meshopt_compression",
    "KHR_meshopt_compression"};

/// Of a file, without those that are blank.
class Lines {
 public:
  Lines(ConfinedFiles& files, const std::string& path)
      : files_(files), file_(files.Open(path.c_str(), "rb")) {
    if (!file_) throw MeshError("it cannot be opened", MeshFault::kUnreadable);
  }
  ~Lines() { files_.Close(file_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  /// These are lines that begin with it.
  void skipComments(char begin) { comment_ = begin; }

  /// At most `most` bytes of it, the rest of which is the next line. Nothing at the end.
  std::optional<std::string> next(std::size_t most = SIZE_MAX) {
    std::string line;
    while (read()) {
      const char c = buffer_[next_++];
      const bool is_end = c == '\n' || c == '\r';
      if (!is_end) line += c;
      if (!is_end && line.size() < most) continue;
      if (hasContent(line)) return line;
      line.clear();
    }
    if (hasContent(line)) return line;
    return std::nullopt;
  }

 private:
  bool hasContent(const std::string& line) const {
    const std::size_t begin = line.find_first_not_of(" \t");
    return begin != std::string::npos && line[begin] != comment_;
  }

  bool read() {
    if (next_ < end_) return true;
    next_ = 0;
    end_ = file_->Read(buffer_.data(), 1, buffer_.size());
    return end_ > 0;
  }

  ConfinedFiles& files_;
  Assimp::IOStream* file_;
  std::array<char, 1 << 16> buffer_;
  std::size_t next_ = 0, end_ = 0;
  char comment_ = '\n';  // none
};

[[noreturn]] void refuseCutOff(const std::string& fault) {
  throw MeshError("it " + fault + ", as if it was cut off");
}

/// The number of corners with which the line of a face begins.
std::size_t cornersOf(const std::string& line, const std::string& place) {
  char* end = nullptr;
  const std::size_t result = std::strtoull(line.c_str(), &end, 10);
  if (end != line.c_str() && (*end == '\0' || *end == ' ' || *end == '\t')) return result;
  throw MeshError("it does not begin with a number of corners in " + place);
}

/// Each in a line: vertices, say. Faces begin with a list.
struct Elements {
  std::string name;
  std::size_t count = 0;
  bool are_faces = false;
};

void check(Lines& lines, const Elements& elements, std::size_t most_corners = SIZE_MAX) {
  for (std::size_t i = 0; i < elements.count; ++i) {
    const auto line = lines.next();
    if (!line) {
      refuseCutOff("ends after " + std::to_string(i) + " of " + std::to_string(elements.count) +
                   " lines of " + elements.name);
    }
    if (!elements.are_faces) continue;
    const std::string place = "line " + std::to_string(i) + " of " + elements.name;
    const std::size_t corners = cornersOf(*line, place);
    if (corners > most_corners) {
      throw MeshError("it has more corners than the " + std::to_string(most_corners) +
                      " that assimp reads in " + place + "; store triangles");
    }
    std::istringstream words(*line);
    std::size_t found = 0;
    for (std::string word; found <= corners && words >> word;)
      ++found;
    if (found <= corners) {
      refuseCutOff("has " + std::to_string(found - 1) + " of " + std::to_string(corners) +
                   " corners in " + place);
    }
  }
}

void checkPly(Lines& lines) {
  std::vector<Elements> elements;
  bool is_text = false, is_first = false;
  for (;;) {
    const auto line = lines.next(kMaxHeaderLine);
    if (!line) refuseCutOff("has no end_header");
    std::istringstream words(*line);
    std::string keyword, word;
    words >> keyword >> word;
    if (keyword == "end_header") break;
    if (keyword == "format") is_text = word == "ascii";
    if (keyword == "element") {
      if (word == "tristrips")
        throw MeshError("it is made of triangle strips, which assimp misreads; store triangles");
      elements.push_back({word});
      words >> elements.back().count;
    }
    if (keyword == "property" && is_first) elements.back().are_faces = word == "list";
    is_first = keyword == "element";
  }
  if (!is_text) return;
  for (const Elements& each : elements)
    check(lines, each);
}

void checkOff(Lines& lines) {
  std::vector<std::size_t> counts;
  std::size_t wanted = 3;
  while (const auto line = lines.next()) {
    std::istringstream words(*line);
    for (std::string word; counts.size() < wanted && words >> word;) {
      if (word == "BINARY") return;
      if (word[0] == '#') break;
      if (std::isdigit(static_cast<unsigned char>(word[0])) && word.find("OFF") == word.npos) {
        counts.push_back(std::strtoull(word.c_str(), nullptr, 10));
      } else if (word.find('n') != word.npos) {
        wanted = 4;  // the number of dimensions comes first
      }
    }
    if (counts.size() == wanted) break;
  }
  if (counts.size() < wanted) return;
  check(lines, {"vertices", counts[wanted - 3], false});
  check(lines, {"faces", counts[wanted - 2], true}, kMostOffCorners);
}

/// A glTF that uses an extension has its name in quotes in its JSON.
void checkGltf(Lines& lines) {
  while (const auto line = lines.next()) {
    for (const char* const name : kUnknownToAssimp) {
      if (line->find('"' + std::string(name) + '"') != line->npos) {
        throw MeshError("it uses the extension " + std::string(name) +
                        ", which assimp does not know; export it without");
      }
    }
  }
}

bool isNamed(const std::string& path, const std::string& extension) {
  std::string end = path.substr(path.size() - std::min(path.size(), extension.size()));
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return end == extension;
}

}  // namespace

void refuseMisread(ConfinedFiles& files, const std::string& path) {
  Lines lines(files, path);
  if (isNamed(path, ".off")) {
    lines.skipComments('#');
    checkOff(lines);
  } else if (isNamed(path, ".gltf") || isNamed(path, ".glb")) {
    checkGltf(lines);
  } else if (const auto first = lines.next(kMaxHeaderLine);
             first && first->compare(0, 3, "ply") == 0) {
    checkPly(lines);
  }
}

}  // namespace link_bounds

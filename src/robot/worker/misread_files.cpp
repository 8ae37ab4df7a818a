// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts the lines and corners of texts as assimp's readers do: each vertex or face has a line.
#include "robot/worker/misread_files.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace link_bounds {
namespace {

/// Of a text; those of real files take less than 1 KiB.
constexpr std::size_t kMaxHeaderLine = 1 << 16;

/// Assimp leaves out faces with more.
constexpr std::size_t kMaxCornersInOff = 9;

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

  /// The text as it is.
  std::string all() {
    std::string text(file_->FileSize(), ' ');
    text.resize(file_->Read(text.data(), 1, text.size()));
    return text;
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

/// Of the lines of a text: a scalar is one word, a list its length and as many words.
enum class Property { kScalar, kList, kListOfFloatLength };

struct Elements {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

/// The length with which a list begins.
std::size_t lengthOf(const std::string& word, Property property, const std::string& place) {
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  const bool is_number = end != word.c_str() && *end == '\0' && number >= 0 && number < 1e9;
  const bool has_digits_only = word.find_first_not_of("0123456789") == word.npos;
  if (is_number && (has_digits_only || property == Property::kListOfFloatLength))
    return static_cast<std::size_t>(number);
  throw MeshError("\"" + word + "\" is no number of corners, in " + place);
}

void check(Lines& lines, const Elements& elements, std::size_t most_corners = SIZE_MAX) {
  for (std::size_t i = 0; i < elements.count; ++i) {
    const auto line = lines.next();
    const std::string place = "line " + std::to_string(i) + " of " + elements.name;
    if (!line) refuseCutOff("ends before " + place);
    std::istringstream words(*line);
    std::string word;
    const auto take = [&](std::size_t count) {
      for (; count > 0; --count) {
        if (!(words >> word)) refuseCutOff("has too few numbers in " + place);
      }
    };
    for (const Property property : elements.properties) {
      take(1);
      if (property == Property::kScalar) continue;
      const std::size_t length = lengthOf(word, property, place);
      if (length > most_corners) {
        throw MeshError("it has more corners than the " + std::to_string(most_corners) +
                        " that assimp reads, in " + place + "; store triangles");
      }
      take(length);
    }
  }
}

void checkPly(Lines& lines) {
  std::vector<Elements> elements;
  bool is_text = false;
  for (;;) {
    const auto line = lines.next(kMaxHeaderLine);
    if (!line) refuseCutOff("has no end_header");
    std::istringstream words(*line);
    std::string keyword, word, type;
    words >> keyword >> word >> type;
    if (keyword == "end_header") break;
    if (keyword == "format") is_text = word == "ascii";
    if (keyword == "element") {
      if (word == "tristrips")
        throw MeshError("it is made of triangle strips, which assimp misreads; store triangles");
      elements.push_back({word, std::strtoull(type.c_str(), nullptr, 10), {}});
    }
    if (keyword == "property" && !elements.empty()) {
      const bool is_float = type[0] == 'f' || type[0] == 'd';
      elements.back().properties.push_back(word != "list" ? Property::kScalar
                                           : is_float     ? Property::kListOfFloatLength
                                                          : Property::kList);
    }
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
  check(lines, {"vertices", counts[wanted - 3], {}});
  check(lines, {"faces", counts[wanted - 2], {Property::kList}}, kMaxCornersInOff);
}

/// A glTF that uses an extension has its name in quotes in its JSON.
void checkGltf(Lines& lines) {
  const std::string text = lines.all();
  for (const char* const name : kUnknownToAssimp) {
    if (text.find('"' + std::string(name) + '"') != text.npos) {
      throw MeshError("it uses the extension " + std::string(name) +
                      ", which assimp does not know; export it without");
    }
  }
}

/// Assimp reads what is behind an array where an accessor reaches beyond it.
class AccessorCheck : public tinyxml2::XMLVisitor {
 public:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute*) override {
    const std::string name = element.Name();
    const char* const id = element.Attribute("id");
    const char* const source = element.Attribute("source");
    if (name == "float_array" && id) sizes_[id] = numberOf(element, "count", 0);
    if (name != "accessor" || !source) return true;
    double params = 0;
    for (auto* each = element.FirstChildElement("param"); each;
         each = each->NextSiblingElement("param"))
      ++params;
    const double last = numberOf(element, "count", 0) - 1;
    if (last < 0) return true;
    const double begin = numberOf(element, "offset", 0) + last * numberOf(element, "stride", 1);
    ends_.emplace_back(source, begin + params);
    return true;
  }

  void refuse() const {
    for (const auto& [source, end] : ends_) {
      const auto size = sizes_.find(source.substr(source.find('#') + 1));
      if (size != sizes_.end() && !(end <= size->second))
        throw MeshError("an accessor reaches beyond its float_array \"" + source + "\"");
    }
  }

 private:
  /// As a double, which does not overflow.
  static double numberOf(const tinyxml2::XMLElement& element, const char* name, double missing) {
    const char* const text = element.Attribute(name);
    return text ? std::strtod(text, nullptr) : missing;
  }

  std::map<std::string, double> sizes_;               ///< of arrays, by id
  std::vector<std::pair<std::string, double>> ends_;  ///< of accessors
};

void checkCollada(Lines& lines) {
  const std::string text = lines.all();
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) return;
  AccessorCheck accessors;
  document.Accept(&accessors);
  accessors.refuse();
}

bool isNamed(const std::string& path, const std::string& extension) {
  std::string end = path.substr(path.size() - std::min(path.size(), extension.size()));
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return end == extension;
}

/// The word is alone in its line: the header of a binary STL may begin with the same letters.
bool isPly(const std::string& first_line) {
  std::istringstream words(first_line);
  std::string word, next;
  words >> word >> next;
  return word.size() == 3 && isNamed(word, "ply") && next.empty();
}

}  // namespace

void refuseMisread(ConfinedFiles& files, const std::string& path) {
  Lines lines(files, path);
  if (isNamed(path, ".off")) {
    lines.skipComments('#');
    checkOff(lines);
  } else if (isNamed(path, ".gltf") || isNamed(path, ".glb")) {
    checkGltf(lines);
  } else if (isNamed(path, ".dae")) {
    checkCollada(lines);
  } else if (isPly(lines.next(kMaxHeaderLine).value_or(""))) {
    checkPly(lines);
  }
}

}  // namespace link_bounds

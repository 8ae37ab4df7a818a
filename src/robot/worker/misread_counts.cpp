// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats whose header says how much follows. In a text, each vertex or face has a line.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "robot/worker/misread_formats.h"

namespace link_bounds {
namespace {

/// Assimp leaves out faces with more corners.
constexpr std::size_t kMaxCornersInOff = 9;

/// A scalar, or a list after its length.
struct Property {
  bool is_list = false;
  std::string length_type;  ///< of a list
  std::string type;
  std::string name;
};

struct Elements {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

constexpr std::pair<const char*, std::size_t> kSizes[] = {
    {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
    {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
    {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};

bool isOfFloats(const std::string& type) {
  return type[0] == 'f' || type[0] == 'd';
}

/// Throws for a type that PLY does not have.
std::size_t sizeOf(const std::string& type) {
  for (const auto& [name, size] : kSizes)
    if (type == name) return size;
  throw MeshError("a property has the unknown type " + inQuotes(type));
}

[[noreturn]] void refuseRest() {
  throw MeshError("it has more data than its header says");
}

/// The length with which a list begins.
std::size_t lengthOf(std::string_view word, bool is_float, const std::string& place) {
  const double number = isNumber(word) ? std::strtod(std::string(word).c_str(), nullptr) : -1;
  if (number >= 0 && number < 1e9 && (is_float || isIndex(word)))
    return static_cast<std::size_t>(number);
  throw MeshError(inQuotes(word) + " is no number of corners, in " + place);
}

/// A line of a text. Words after those that are read may be a colour.
class Line {
 public:
  Line(std::string_view text, std::string place) : words_(text), place_(std::move(place)) {}

  std::string_view number() {
    const std::string_view word = next();
    requireNumber(word, place_);
    return word;
  }
  void index() { requireIndex(next(), place_); }
  std::size_t length(bool is_float) { return lengthOf(next(), is_float, place_); }
  void end() {
    if (!words_.next().empty()) throw MeshError("it has too many numbers in " + place_);
  }
  std::size_t allNumbers(char comment = '\0') { return words_.countNumbers(place_, comment); }
  const std::string& place() const { return place_; }

 private:
  std::string_view next() {
    const std::string_view word = words_.next();
    if (word.empty()) refuseCutOff("has too few numbers in " + place_);
    return word;
  }

  Words words_;
  std::string place_;
};

/// Calls check(line) for each of the next `count` lines.
template <class Check>
void eachLine(Lines& lines, const std::string& name, std::size_t count, const Check& check) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto text = lines.next();
    std::string place = "line " + std::to_string(i) + " of " + name;
    if (!text) refuseCutOff("ends before " + place);
    Line line(*text, std::move(place));
    check(line);
  }
}

bool hasLists(const Elements& elements) {
  return std::any_of(elements.properties.begin(), elements.properties.end(),
                     [](const Property& property) { return property.is_list; });
}

/// A colour may follow the corners of a face without being announced. All lines must have the same
/// count of further numbers, so that corners that a face does not count are noticed.
void checkText(Lines& lines, const Elements& elements) {
  std::optional<std::size_t> colours;
  eachLine(lines, elements.name, elements.count, [&](Line& line) {
    for (const Property& property : elements.properties) {
      std::size_t count = property.is_list ? line.length(isOfFloats(property.length_type)) : 1;
      const bool has_indices =
          property.name.rfind("vertex_ind", 0) == 0 && !isOfFloats(property.type);
      for (; count > 0; --count) {
        if (has_indices) {
          line.index();
        } else {
          line.number();
        }
      }
    }
    if (!hasLists(elements)) return line.end();
    const std::size_t rest = line.allNumbers();
    if (rest != colours.value_or(rest))
      throw MeshError("more or fewer numbers than before follow the corners in " + line.place());
    colours = rest;
  });
}

/// The data of a PLY, of which only the lengths of lists are read.
class Data {
 public:
  Data(std::string bytes, bool is_big_endian)
      : bytes_(std::move(bytes)), is_big_endian_(is_big_endian) {}

  void skip(std::size_t count, std::size_t size) {
    if (size > 0 && count > (bytes_.size() - at_) / size) refuseCutOff("has too few bytes");
    at_ += count * size;
  }

  std::size_t length(const std::string& type) {
    const std::size_t size = sizeOf(type);
    skip(1, size);
    std::string bytes = bytes_.substr(at_ - size, size);
    if (is_big_endian_) std::reverse(bytes.begin(), bytes.end());
    if (type[0] == 'f' && size == 4) return fromFloat<float>(bytes);
    if (isOfFloats(type)) return fromFloat<double>(bytes);
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), size);
    return length;
  }

  bool beginsWith(char byte) const { return !bytes_.empty() && bytes_[0] == byte; }
  bool hasRest() const { return bytes_.find_first_not_of(" \t\r\n", at_) != std::string::npos; }

 private:
  template <class Number>
  static std::size_t fromFloat(const std::string& bytes) {
    Number number = 0;
    std::memcpy(&number, bytes.data(), sizeof(number));
    return number >= 0 && number < 1e9 ? static_cast<std::size_t>(number) : SIZE_MAX;
  }

  std::string bytes_;
  std::size_t at_ = 0;
  bool is_big_endian_;
};

void checkBinary(Data& data, const Elements& elements) {
  std::size_t size = 0;
  for (const Property& property : elements.properties)
    size += sizeOf(property.type);
  if (!hasLists(elements)) return data.skip(elements.count, size);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (const Property& property : elements.properties) {
      const std::size_t length = property.is_list ? data.length(property.length_type) : 1;
      // This may be the rest of a face whose beginning was read as a vertex.
      if (i == 0 && length == 0 && property.name.rfind("vertex_ind", 0) == 0)
        throw MeshError("its first face has no corners, as where a count of vertices is wrong");
      data.skip(length, sizeOf(property.type));
    }
  }
}

constexpr std::array kPlyWords{"ply", "format", "comment", "obj_info", "element", "property"};

struct PlyHeader {
  std::string format;
  std::vector<Elements> elements;
};

/// Assimp leaves out the properties of an element that follow a comment or another line. In a text,
/// this is harmless for all numbers but coordinates.
void checkProperty(const Property& property, bool is_after_other, bool is_text) {
  sizeOf(property.type);
  if (property.is_list) sizeOf(property.length_type);
  const bool is_harmless = is_text && !property.is_list && property.name != "x" &&
                           property.name != "y" && property.name != "z";
  if (is_after_other && !is_harmless)
    throw MeshError("a comment or another line stands between an element and its property " +
                    inQuotes(property.name) + ", where assimp misreads it; remove that line");
}

PlyHeader readPlyHeader(Lines& lines) {
  PlyHeader header;
  bool is_first = true, is_after_other = false;
  for (;;) {
    const auto line = lines.next(kMaxHeaderLine);
    if (!line) refuseCutOff("has no end_header");
    Words words(*line);
    const std::string keyword(words.next()), first(words.next()), second(words.next());
    const std::string word = inSmallLetters(keyword);
    if (keyword == "end_header") return header;
    if (std::find(kPlyWords.begin(), kPlyWords.end(), word) == kPlyWords.end())
      throw MeshError(inQuotes(keyword) + " is no word of its header");
    if (keyword == "format") {
      header.format = first;
      if (is_after_other)
        throw MeshError(
            "a comment stands before the format in its header, where assimp misreads it; remove "
            "the comment");
    }
    if (keyword == "element") {
      if (first == "tristrips")
        throw MeshError("it is made of triangle strips, which assimp misreads; store triangles");
      header.elements.push_back({first, countOf(second), {}});
    }
    if (keyword != "property" && !is_first) is_after_other = keyword != "element";
    is_first = false;
    if (keyword != "property" || header.elements.empty()) continue;
    Property property;
    property.is_list = first == "list";
    property.length_type = property.is_list ? second : "";
    property.type = property.is_list ? std::string(words.next()) : first;
    property.name = property.is_list ? std::string(words.next()) : second;
    checkProperty(property, is_after_other, header.format == "ascii");
    header.elements.back().properties.push_back(std::move(property));
  }
}

/// Assimp takes 0 for a coordinate that is missing, and the last of two with one name.
void checkCoordinates(const PlyHeader& header) {
  for (const Elements& elements : header.elements) {
    const auto& properties = elements.properties;
    for (const char* const name : {"x", "y", "z"}) {
      const auto is_it = [&](const Property& property) { return property.name == name; };
      const auto count = std::count_if(properties.begin(), properties.end(), is_it);
      if (elements.name == "vertex" && count != 1)
        throw MeshError("its vertices have " + std::string(count == 0 ? "no" : "more than one") +
                        " property " + name);
    }
  }
}

/// Assimp does not skip the data of an element that it does not know.
void checkOrder(const PlyHeader& header) {
  constexpr std::array kKnown{"vertex", "face", "edge", "material"};
  const Elements* unknown = nullptr;
  for (const Elements& elements : header.elements) {
    if (std::find(kKnown.begin(), kKnown.end(), elements.name) == kKnown.end()) {
      if (elements.count > 0) unknown = &elements;
    } else if (unknown) {
      throw MeshError("assimp misreads the element " + inQuotes(elements.name) +
                      ", because it does not know " + inQuotes(unknown->name) +
                      " before it; move or remove that");
    }
  }
}

}  // namespace

void checkPly(Lines& lines) {
  const PlyHeader header = readPlyHeader(lines);
  checkCoordinates(header);
  checkOrder(header);
  if (header.format == "ascii") {
    for (const Elements& each : header.elements)
      checkText(lines, each);
    if (lines.next()) refuseRest();
    return;
  }
  const bool is_after_cr = lines.isAfterCr();
  Data data(lines.rest(), header.format == "binary_big_endian");
  if (!is_after_cr && data.beginsWith('\n'))
    throw MeshError(
        "assimp takes the first byte of its data, 0x0A, for an end of the header; "
        "store it as text");
  for (const Elements& each : header.elements)
    checkBinary(data, each);
  if (data.hasRest()) refuseRest();
}

void checkOff(Lines& lines) {
  lines.skipComments('#');
  std::vector<std::size_t> counts;
  std::size_t wanted = 3;
  while (const auto line = lines.next()) {
    Words words(*line);
    for (std::string_view word = words.next(); counts.size() < wanted && !word.empty();
         word = words.next()) {
      if (word == "BINARY") return;
      if (word[0] == '#') break;
      if (std::isdigit(static_cast<unsigned char>(word[0])) && word.find("OFF") == word.npos) {
        counts.push_back(countOf(word));
      } else if (word.find('n') != word.npos) {
        wanted = 4;  // the number of dimensions comes first
      }
    }
    if (counts.size() == wanted) break;
  }
  if (counts.size() < wanted) return;
  std::optional<std::size_t> numbers;  // of the first vertex, maybe with a colour
  eachLine(lines, "vertices", counts[wanted - 3], [&numbers](Line& line) {
    const std::size_t count = line.allNumbers('#');
    if (count != numbers.value_or(count))
      throw MeshError("it has more or fewer numbers than before in " + line.place());
    numbers = count;
  });
  eachLine(lines, "faces", counts[wanted - 2], [](Line& line) {
    const std::size_t length = line.length(false);
    if (length > kMaxCornersInOff) {
      throw MeshError("it has more corners than the " + std::to_string(kMaxCornersInOff) +
                      " that assimp reads, in " + line.place() + "; store triangles");
    }
    for (std::size_t i = 0; i < length; ++i)
      line.index();
  });
  if (lines.next()) refuseRest();
}

}  // namespace link_bounds

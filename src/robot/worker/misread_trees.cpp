// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats of which assimp reads other parts than are there.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "robot/worker/json_text.h"
#include "robot/worker/misread_formats.h"
#include "robot/worker/xml_tags.h"

namespace link_bounds {
namespace {

/// Extensions of glTF that change where vertices are, and that assimp leaves out.
constexpr std::array<const char*, 4> kUnknownToAssimp{
    "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "EXT_meshopt_compression",
    "KHR_meshopt_compression"};

/// Beginnings of those that may be required, and change no vertex or are known to assimp.
constexpr std::array<const char*, 11> kHarmless{
    "KHR_materials_",  "KHR_texture_",    "EXT_texture_", "MSFT_texture_",
    "KHR_lights_",     "EXT_lights_",     "KHR_xmp",      "KHR_draco_mesh_compression",
    "KHR_techniques_", "KHR_binary_glTF", "VRM"};

/// The componentType of a glTF that assimp reads as a position.
constexpr char kFloat[] = "5126";

/// Elements of Collada that hold numbers, and how many; assimp leaves out what follows.
constexpr std::pair<std::string_view, std::size_t> kElementsOfNumbers[] = {
    {"matrix", 16}, {"translate", 3}, {"rotate", 4}, {"scale", 3}, {"lookat", 9}};

/// Assimp reads what is behind an array where an accessor reaches beyond it, takes the index -1 for
/// 0, and x for a coordinate of a position that has no name. Where a position has more coordinates
/// than the stride, it takes those of the next one.
class ColladaCheck {
 public:
  void run(XmlTags tags) {
    while (tags.next()) {
      if (tags.isText()) {
        checkText(tags);
      } else {
        checkTag(tags);
      }
    }
    for (const auto& [source, end] : ends_)
      checkEnd(source, end);
    for (const std::string& source : positions_)
      checkPosition(source);
  }

 private:
  void checkTag(const XmlTags& tags) {
    const std::string_view name = tags.name();
    if (tags.isBegin()) {
      const auto meter = name == "unit" ? tags.attribute("meter") : std::nullopt;
      if (meter) requireNumber(Words(*meter).next(), "the meter of its <unit>");
      if (name == "float_array") noteArray(tags);
      if (name == "accessor") noteAccessor(tags);
      if (name == "param") noteParam(tags);
      if (name == "source") source_ = tags.attribute("id").value_or("");
      if (name == "input" && tags.attribute("semantic") == "POSITION")
        positions_.insert(withoutHash(tags.attribute("source").value_or("")));
      if (isOther(name)) ++others_;
    }
    if (tags.isEnd() && isOther(name)) --others_;
    if (tags.isEnd() && name == "accessor" && !ends_.empty() && has_items_)
      ends_.back().second += params_;
  }

  /// Elements in it may have other meanings, or say nothing of geometry.
  static bool isOther(std::string_view element) {
    return element == "extra" || element == "library_animations";
  }

  void noteArray(const XmlTags& tags) {
    array_size_ = numberOf(tags, "count", std::numeric_limits<double>::infinity());
    const auto id = tags.attribute("id");
    if (!id) return;
    const double size = numberOf(tags, "count", 0);
    const auto [entry, is_new] = sizes_.try_emplace(std::string(*id), size);
    if (!is_new) entry->second = std::min(entry->second, size);
  }

  void noteAccessor(const XmlTags& tags) {
    const auto source = tags.attribute("source");
    coordinates_[source_];
    const double last = numberOf(tags, "count", 0) - 1;
    params_ = 0;
    has_items_ = source && last >= 0;
    if (!has_items_) return;
    const double stride = numberOf(tags, "stride", 1);
    if (others_ == 0) strides_[source_] = stride;
    const double begin = numberOf(tags, "offset", 0) + last * stride;
    ends_.emplace_back(withoutHash(*source), begin);
  }

  void noteParam(const XmlTags& tags) {
    ++params_;
    coordinates_[source_].insert(std::string(tags.attribute("name").value_or("")));
  }

  static std::string withoutHash(std::string_view reference) {
    return std::string(reference.substr(reference.find('#') + 1));
  }

  /// How many numbers an element holds; nothing for others.
  std::optional<double> numbersOf(std::string_view element) const {
    if (element == "float_array") return array_size_;
    for (const auto& [name, count] : kElementsOfNumbers)
      if (element == name) return static_cast<double>(count);
    return std::nullopt;
  }

  void checkText(const XmlTags& tags) {
    const std::optional<double> count = numbersOf(tags.name());
    if (!count && tags.name() != "p") return;
    const std::string text = tags.text();
    Words words(text);
    const std::string place = "the <" + std::string(tags.name()) + "> of " + tags.place();
    if (count && static_cast<double>(words.countNumbers(place)) > *count && others_ == 0)
      throw MeshError("it has too many numbers in " + place);
    for (auto word = words.next(); !word.empty(); word = words.next())
      requireIndex(word, place);
  }

  void checkPosition(const std::string& source) const {
    const auto found = coordinates_.find(source);
    if (found == coordinates_.end()) return;
    for (const char* const name : {"X", "Y", "Z"})
      if (found->second.count(name) == 0)
        throw MeshError("the accessor of its positions has no param \"" + std::string(name) + "\"");
    const auto stride = strides_.find(source);
    if (stride != strides_.end() && stride->second < 3)
      throw MeshError("the accessor of its positions has a stride below 3");
  }

  void checkEnd(const std::string& source, double end) const {
    const auto size = sizes_.find(source);
    if (size != sizes_.end() && !(end <= size->second))
      throw MeshError("an accessor reaches beyond its float_array \"" + source + "\"");
  }

  /// As a double, which does not overflow.
  static double numberOf(const XmlTags& tags, std::string_view name, double missing) {
    const auto text = tags.attribute(name);
    if (!text) return missing;
    const std::string word(Words(*text).next());
    requireNumber(word, "the " + std::string(name) + " of " + tags.place());
    return std::strtod(word.c_str(), nullptr);
  }

  int others_ = 0;                                    ///< open elements of isOther()
  double array_size_ = 0;                             ///< of the last array
  std::map<std::string, double> sizes_;               ///< of arrays, by id; the smallest counts
  std::vector<std::pair<std::string, double>> ends_;  ///< of accessors
  double params_ = 0;                                 ///< of the last accessor
  std::string source_;                                ///< id of the last one
  std::map<std::string, std::set<std::string>> coordinates_;  ///< params of accessors, by sources
  std::map<std::string, double> strides_;                     ///< of accessors, by sources
  std::set<std::string> positions_;                           ///< ids of sources
  bool has_items_ = false;                                    ///< it has
};

[[noreturn]] void refuseExtension(const std::string& name) {
  throw MeshError("it uses the extension " + name +
                  ", which assimp does not know; export it without");
}

/// The name of an extension that is used stands as a name or string.
void refuseUnknown(const Json& value) {
  for (const char* const unknown : kUnknownToAssimp)
    if (value.text == unknown) refuseExtension(unknown);
  for (const auto& [name, member] : value.members) {
    for (const char* const unknown : kUnknownToAssimp)
      if (name == unknown) refuseExtension(unknown);
    refuseUnknown(member);
  }
}

bool isHarmless(const std::string& extension) {
  return std::any_of(kHarmless.begin(), kHarmless.end(),
                     [&](const char* beginning) { return extension.rfind(beginning, 0) == 0; });
}

/// A binary file has its size before it.
std::string_view jsonOf(const std::string& file) {
  constexpr std::size_t kAtSize = 12, kBegin = 20;
  const std::string_view text = file;
  if (text.substr(0, 4) != "glTF" || text.size() < kBegin) return text;
  std::uint32_t size = 0;
  std::memcpy(&size, file.data() + kAtSize, sizeof(size));
  return text.substr(kBegin, size);
}

}  // namespace

void checkCollada(Lines& lines) {
  const std::string text = lines.all();
  ColladaCheck().run(XmlTags(text));
}

void checkGltf(Lines& lines) {
  const std::string file = lines.all();
  const Json document = parseJson(jsonOf(file));
  refuseUnknown(document);
  for (const auto& [number, name] : document["extensionsRequired"].members) {
    if (!isHarmless(name.text)) refuseExtension(name.text);
  }
  std::set<std::string> others;
  for (const auto& [number, accessor] : document["accessors"].members)
    if (accessor["componentType"].text != kFloat) others.insert(number);
  for (const auto& [number, mesh] : document["meshes"].members) {
    for (const auto& [part, primitive] : mesh["primitives"].members) {
      if (others.count(primitive["attributes"]["POSITION"].text) > 0)
        throw MeshError("positions of mesh " + number +
                        " are no floats, which assimp misreads; store floats");
    }
  }
}

}  // namespace link_bounds

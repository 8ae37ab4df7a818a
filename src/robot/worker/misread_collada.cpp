// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Collada, of which assimp leaves out elements that it does not know.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "robot/worker/misread_formats.h"
#include "robot/worker/xml_tags.h"

namespace link_bounds {
namespace {

/// Elements of Collada that hold numbers, and how many; assimp leaves out what follows.
constexpr std::pair<std::string_view, std::size_t> kElementsOfNumbers[] = {
    {"matrix", 16}, {"translate", 3}, {"rotate", 4}, {"scale", 3}, {"lookat", 9}};

/// The children that an element that places geometry may have; assimp leaves out any other child.
constexpr std::pair<std::string_view, std::string_view> kChildren[] = {
    {"asset",
     " contributor coverage created extra keywords modified revision subject title unit up_axis "},
    {"geometry", " asset brep convex_mesh extra mesh spline "},
    {"mesh",
     " extra lines linestrips polygons polylist source triangles trifans tristrips vertices "},
    {"node",
     " asset extra instance_camera instance_controller instance_geometry instance_light "
     "instance_node lookat matrix node rotate scale skew translate "},
    {"vertices", " extra input "},
    {"visual_scene", " asset evaluate_scene extra node "}};

constexpr std::string_view kPrimitives =
    " lines linestrips polygons polylist triangles trifans tristrips ";

/// `names` has names between blanks.
bool isIn(std::string_view names, std::string_view name) {
  return names.find(" " + std::string(name) + " ") != names.npos;
}

/// Assimp reads memory behind an array if an accessor reaches beyond it, takes the index -1 for 0,
/// and takes x for a coordinate of a position whose param has no name. Where a position has more
/// coordinates than the stride, it takes those of the next one. It leaves out primitives whose
/// count is 0, and vertices without positions.
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
    for (const std::string& source : positions_)
      checkPosition(source);
    for (const auto& [source, end] : ends_)
      checkEnd(source, end);
    for (const std::string& geometry : used_)
      checkGeometry(geometry);
  }

 private:
  void checkTag(const XmlTags& tags) {
    if (tags.isBegin()) {
      begin(tags);
      open_.emplace_back(tags.name());
    }
    if (!tags.isEnd()) return;
    if (!open_.empty()) open_.pop_back();
    end(tags);
  }

  void begin(const XmlTags& tags) {
    const std::string_view name = tags.name();
    if (isOther(name)) ++others_;
    if (others_ == 0) checkParent(tags);
    const auto meter = name == "unit" ? tags.attribute("meter") : std::nullopt;
    if (meter) requireNumber(Words(*meter).next(), "the meter of its <unit>");
    if (name == "float_array") noteArray(tags);
    if (name == "accessor") noteAccessor(tags);
    if (name == "param") noteParam(tags);
    if (name == "source") source_ = tags.attribute("id").value_or("");
    if (name == "geometry") geometry_ = tags.attribute("id").value_or("");
    if (others_ == 0 && (name == "convex_mesh" || name == "brep")) without_mesh_[geometry_] = name;
    if (others_ == 0 && isIn(" instance_geometry instance_controller instance_node ", name))
      checkPlacement(tags);
    if (name == "vertices") has_positions_ = false;
    if (isIn(kPrimitives, name)) primitives_ = numberOf(tags, "count", 0);
    if (name == "input" && tags.attribute("semantic") == "POSITION") notePositions(tags);
  }

  void end(const XmlTags& tags) {
    const std::string_view name = tags.name();
    if (name == "accessor" && !ends_.empty() && has_items_) ends_.back().second += params_;
    if (name == "source") source_.clear();
    if (open_.size() < sheared_) sheared_ = 0;
    if (name == "vertices" && !has_positions_ && others_ == 0)
      throw MeshError("its <vertices> have no positions, before the end of " + tags.place());
    if (isOther(name)) --others_;
  }

  void checkParent(const XmlTags& tags) {
    const std::string_view parent = open_.empty() ? std::string_view() : open_.back();
    const std::string name(tags.name());
    for (const auto& [known, children] : kChildren)
      if (parent == known && !isIn(children, name))
        throw MeshError("Collada has no <" + name + "> in <" + std::string(parent) + ">, in " +
                        tags.place());
    if (name != "geometry") return;
    const auto id = tags.attribute("id");
    if (id && !geometries_.insert(*id).second)
      throw MeshError("it has two geometries with the id " + inQuotes(*id));
  }

  void notePositions(const XmlTags& tags) {
    positions_.insert(withoutHash(tags.attribute("source").value_or("")));
    has_positions_ = true;
    if (!open_.empty() && isIn(kPrimitives, open_.back()))
      throw MeshError("positions are named outside of <vertices>, in " + tags.place());
  }

  /// Elements inside of it may have other meanings, or say nothing of geometry.
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
    params_of_[source_];
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
    params_of_[source_].emplace_back(tags.attribute("name").value_or(""));
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
    if (tags.name() == "rotate" && others_ == 0 && isInNode()) checkAxis(text, place);
    if (tags.name() == "lookat" && others_ == 0 && isInNode() && sheared_ == 0 && isSheared(text))
      sheared_ = open_.size() - 1;
    for (auto word = words.next(); !word.empty(); word = words.next()) {
      requireIndex(word, place);
      if (!(primitives_ > 0) && others_ == 0)
        throw MeshError("it has more primitives than their count says, in " + place);
    }
  }

  /// Whether the open element is a child of a node.
  bool isInNode() const { return open_.size() > 1 && open_[open_.size() - 2] == "node"; }

  /// The first numbers of a text, 0 for those that it does not have.
  template <std::size_t kCount>
  static std::array<double, kCount> numbersIn(const std::string& text) {
    Words words(text);
    std::array<double, kCount> numbers{};
    for (double& number : numbers)
      number = std::strtod(std::string(words.next()).c_str(), nullptr);
    return numbers;
  }

  /// Assimp scales by the length of an axis.
  static void checkAxis(const std::string& text, const std::string& place) {
    constexpr double kMaxError = 1e-6;
    const std::array<double, 4> numbers = numbersIn<4>(text);
    const double length = std::hypot(numbers[0], numbers[1], numbers[2]);
    if (numbers[3] != 0 && !(std::abs(length - 1) <= kMaxError))
      throw MeshError("the axis has not the length 1 in " + place +
                      ", by which assimp scales; write six digits or more");
  }

  /// Assimp takes the up axis of a <lookat> as it is, so it shears and scales unless the axis has
  /// the length 1 and a right angle to the direction of view. Without a direction of view, because
  /// the eye is at the point of interest, it makes the mesh flat.
  static bool isSheared(const std::string& text) {
    constexpr double kMaxError = 1e-6;
    const std::array<double, 9> numbers = numbersIn<9>(text);
    const Eigen::Map<const Eigen::Vector3d> eye(&numbers[0]), interest(&numbers[3]),
        up(&numbers[6]);
    const Eigen::Vector3d view = interest - eye;
    return !(view.norm() > 0 && std::abs(up.norm() - 1) <= kMaxError &&
             std::abs(up.dot(view.normalized())) <= kMaxError);
  }

  /// Cameras and lights may be below a <lookat> of any kind.
  void checkPlacement(const XmlTags& tags) {
    if (open_.empty() || open_.back() != "node") return;
    if (sheared_ > 0)
      throw MeshError(
          "assimp shears what is below a <lookat> whose up axis has not the length 1 "
          "or no right angle to the view, in " +
          tags.place() + "; write a <matrix>");
    if (tags.name() == "instance_geometry")
      used_.insert(withoutHash(tags.attribute("url").value_or("")));
  }

  void checkGeometry(const std::string& id) const {
    const auto found = without_mesh_.find(id);
    if (found != without_mesh_.end())
      throw MeshError("assimp leaves out the <" + found->second + "> of its geometry " +
                      inQuotes(id) + "; export a <mesh>");
  }

  void checkPosition(const std::string& source) const {
    const auto found = params_of_.find(source);
    if (found == params_of_.end()) return;
    const std::vector<std::string>& params = found->second;
    const auto place = [&params](const char* name) {
      return std::find(params.begin(), params.end(), name);
    };
    for (const char* const name : {"X", "Y", "Z"})
      if (place(name) == params.end())
        throw MeshError("the accessor of its positions has no param \"" + std::string(name) + "\"");
    for (const char* const name : {"R", "G", "B", "S", "T", "P", "U", "V"})
      if (place(name) != params.end() && place(name) > place("X"))
        throw MeshError("assimp takes the param \"" + std::string(name) +
                        "\" of its positions for a coordinate; give it an accessor of its own");
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

  std::vector<std::string> open_;                     ///< names of open elements
  int others_ = 0;                                    ///< open elements of isOther()
  double primitives_ = 0;                             ///< count of the last element of kPrimitives
  bool has_positions_ = false;                        ///< whether the last <vertices> has any
  std::set<std::string> geometries_;                  ///< ids
  double array_size_ = 0;                             ///< of the last array
  std::map<std::string, double> sizes_;               ///< of arrays, by id; the smallest counts
  std::vector<std::pair<std::string, double>> ends_;  ///< by accessor: its array, and its end there
  double params_ = 0;                                 ///< count in the last accessor
  std::string source_;                                ///< id of the open <source>
  std::map<std::string, std::vector<std::string>> params_of_;  ///< of accessors, by sources
  std::map<std::string, double> strides_;                      ///< of accessors, by sources
  std::set<std::string> positions_;                            ///< ids of sources
  bool has_items_ = false;                           ///< whether the last accessor has any
  std::string geometry_;                             ///< id of the last geometry
  std::map<std::string, std::string> without_mesh_;  ///< by id of a geometry: what it has instead
  std::set<std::string> used_;                       ///< ids of geometries that nodes place
  std::size_t sheared_ = 0;  ///< number of open elements at a node with isSheared(); 0: in none
};

}  // namespace

void checkCollada(Lines& lines) {
  const std::string text = lines.all();
  ColladaCheck().run(XmlTags(text));
}

}  // namespace link_bounds

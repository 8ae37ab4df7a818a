// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Unknown fields are refused, because a misspelt "frame" would move the zone.
#include "tools/bag_bounds/watch/zones.h"

#include <yaml-cpp/yaml.h>

#include <optional>
#include <set>
#include <utility>

#include "tools/command_line/options.h"
#include "tools/command_line/yaml_document.h"
#include "world/model/model.h"

namespace link_bounds {
namespace {

constexpr char kExample[] = "NAME: {frame: map, min: [0, 0, 0], max: [1, 1, 1]}";

class ZoneReader {
 public:
  explicit ZoneReader(std::string file) : file_(std::move(file)) {}

  std::vector<Zone> read(const YAML::Node& root) {
    if (root.IsSequence()) {
      for (const YAML::Node& entry : root)
        add(nameIn(entry), entry);
    } else if (root.IsMap()) {
      for (const auto& entry : root)
        add(scalar(entry.first), entry.second);
    }
    if (zones_.empty()) throw UsageError(file_ + " has no zones; write a line such as " + kExample);
    return std::move(zones_);
  }

 private:
  [[noreturn]] void refuse(const std::string& name, const std::string& reason) const {
    throw UsageError(file_ + ": zone \"" + name + "\": " + reason);
  }

  std::string nameIn(const YAML::Node& entry) const {
    const std::string name = entry.IsMap() ? scalar(entry["name"]) : "";
    if (!name.empty()) return name;
    throw UsageError(file_ + ": entry " + std::to_string(zones_.size() + 1) +
                     " of the list has no name; add name: NAME");
  }

  void add(const std::string& name, const YAML::Node& fields) {
    if (name.empty())
      throw UsageError(file_ + ": a zone has no name; write a line such as " + kExample);
    if (!names_.insert(name).second) refuse(name, "there are two of this name; rename one");
    if (!fields.IsMap())
      refuse(name, std::string("it has no fields; write a line such as ") + kExample);
    checkFields(name, fields);
    Zone zone{name, "", Aabb(corner(name, fields, "min"), corner(name, fields, "max"))};
    if (fields["frame"]) zone.frame = tfName("", scalar(fields["frame"]));
    if (fields["frame"] && zone.frame.empty())
      refuse(name,
             "frame is no name; write that of a frame of tf, or leave the field out for the fixed "
             "frame");
    for (const int axis : {0, 1, 2}) {
      if (zone.box.min()[axis] > zone.box.max()[axis])
        refuse(name,
               std::string("min is above max in ") + "xyz"[axis] + "; exchange the two numbers");
    }
    zones_.push_back(zone);
  }

  void checkFields(const std::string& name, const YAML::Node& fields) const {
    static const std::set<std::string> kFields{"name", "frame", "min", "max"};
    std::set<std::string> seen;
    for (const auto& field : fields) {
      const std::string key = scalar(field.first);
      if (!seen.insert(key).second) refuse(name, "\"" + key + "\" is there twice; remove one");
      if (!kFields.count(key))
        refuse(name, "there is no field \"" + key + "\"; the fields are frame, min and max");
    }
  }

  Eigen::Vector3d corner(const std::string& name, const YAML::Node& fields,
                         const char* field) const {
    const YAML::Node numbers = fields[field];
    const std::string remedy = std::string(field) + " must be three numbers [m], such as [0, 0, 0]";
    if (!numbers || !numbers.IsSequence() || numbers.size() != 3) refuse(name, remedy);
    Eigen::Vector3d result;
    for (const int axis : {0, 1, 2}) {
      const std::string text = scalar(numbers[static_cast<std::size_t>(axis)]);
      const std::optional<double> number = toNumber(text);
      if (!number) refuse(name, remedy + ", but one of them is \"" + text + "\"");
      result[axis] = *number;
    }
    return result;
  }

  std::string file_;
  std::vector<Zone> zones_;
  std::set<std::string> names_;
};

}  // namespace

std::vector<Zone> parseZones(const std::string& text, const std::string& file) {
  return readYaml<ZoneReader>(text, file);
}

}  // namespace link_bounds

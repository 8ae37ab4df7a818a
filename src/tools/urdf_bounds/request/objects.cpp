// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields are those of visualization_msgs/Marker. Unknown fields are refused: a misspelt pose
// would be ignored, and the object would be at the wrong place.
#include "tools/urdf_bounds/request/objects.h"

#include <yaml-cpp/yaml.h>

#include <set>

#include "tools/command_line/options.h"
#include "tools/command_line/yaml_document.h"

namespace link_bounds {
namespace {

constexpr char kExample[] =
    "NAME: {type: CUBE, pose: {position: {x: 1, y: 0, z: 0}}, scale: {x: 1, y: 1, z: 1}}";

class ObjectReader {
 public:
  explicit ObjectReader(std::string file) : file_(std::move(file)) {}

  Robot read(const YAML::Node& root) {
    if (root.IsMap()) {
      for (const auto& entry : root)
        add(scalar(entry.first), entry.second);
    }
    if (objects_.links.empty())
      throw UsageError(file_ + " has no objects; write a line such as " + kExample);
    objects_.name = file_;
    return std::move(objects_);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw UsageError(file_ + ": object \"" + name_ + "\": " + reason);
  }

  void checkFields(const YAML::Node& node, const std::string& what,
                   const std::set<std::string>& known) const {
    if (!node.IsMap()) refuse(what + " has no fields; write a line such as " + kExample);
    std::set<std::string> seen;
    for (const auto& field : node) {
      const std::string key = scalar(field.first);
      if (!seen.insert(key).second) refuse(what + " has \"" + key + "\" twice; remove one");
      if (!known.count(key))
        refuse(what + " has no field \"" + key + "\"; the fields are " + joined(known, ", "));
    }
  }

  double number(const YAML::Node& node, const std::string& field, double otherwise) const {
    if (!node[field]) return otherwise;
    const std::optional<double> value = toNumber(scalar(node[field]));
    if (!value) refuse(field + " is \"" + scalar(node[field]) + "\", but must be a number");
    return *value;
  }

  /// x, y and z of a position or a scale; `otherwise` stands for missing numbers.
  Eigen::Vector3d vector(const YAML::Node& node, const std::string& what, double otherwise) const {
    if (!node) return Eigen::Vector3d::Constant(otherwise);
    checkFields(node, what, {"x", "y", "z"});
    return {number(node, "x", otherwise), number(node, "y", otherwise),
            number(node, "z", otherwise)};
  }

  Eigen::Isometry3d pose(const YAML::Node& node) const {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    if (!node) return result;
    checkFields(node, "pose", {"position", "orientation"});
    result.translation() = vector(node["position"], "position", 0);
    const YAML::Node turn = node["orientation"];
    if (!turn) return result;
    checkFields(turn, "orientation", {"x", "y", "z", "w"});
    Eigen::Quaterniond q(number(turn, "w", 0), number(turn, "x", 0), number(turn, "y", 0),
                         number(turn, "z", 0));
    const double largest = q.coeffs().cwiseAbs().maxCoeff();
    if (!(largest > 0)) refuse("orientation is zero; without a rotation, leave it out");
    q.coeffs() /= largest;  // squares of huge or tiny numbers overflow or vanish
    result.linear() = q.normalized().toRotationMatrix();
    return result;
  }

  void add(const std::string& name, const YAML::Node& fields) {
    name_ = name;
    if (name.empty())
      throw UsageError(file_ + ": an object has no name; write a line such as " + kExample);
    if (!names_.insert(name).second) refuse("there are two of this name; rename one");
    checkFields(fields, "it", {"type", "pose", "scale", "mesh_resource"});
    Element element;
    element.number = 1;
    const std::string type = scalar(fields["type"]);
    const Eigen::Vector3d scale = vector(fields["scale"], "scale", 1);
    if (scale.minCoeff() < 0) refuse("scale is negative; give lengths, turn by the pose");
    if (!(scale.maxCoeff() > 0)) refuse("scale is zero; give lengths");
    element.link_from_shape = pose(fields["pose"]);
    if (type == "MESH_RESOURCE") {
      element.mesh_uri = scalar(fields["mesh_resource"]);
      if (element.mesh_uri.empty())
        refuse("mesh_resource is empty; name a mesh file, such as package://my_package/part.stl");
      element.link_from_shape.scale(scale);
    } else {
      if (fields["mesh_resource"])
        refuse("mesh_resource is for the type MESH_RESOURCE, but the type is \"" + type +
               "\"; correct the type, or remove the field");
      element.solid = chosen<Solid>("type of object \"" + name + "\"", type,
                                    {{"CUBE", Solid::kBox},
                                     {"CYLINDER", Solid::kCylinder},
                                     {"MESH_RESOURCE", Solid::kNone},
                                     {"SPHERE", Solid::kEllipsoid}});
      if (!fields["scale"])
        refuse("it has no scale; give its lengths, as in " + std::string(kExample));
      element.size = scale;
    }
    for (const char* const axis : {"x", "y", "z"}) {
      if (fields["scale"] && !fields["scale"][axis])
        refuse(std::string("its scale has no ") + axis + "; give x, y and z");
    }
    objects_.links.push_back({name, {element}, {}});
  }

  std::string file_;
  std::string name_;  ///< of the object that is read
  std::set<std::string> names_;
  Robot objects_;
};

}  // namespace

Robot parseObjects(const std::string& text, const std::string& file) {
  return readYaml<ObjectReader>(text, file);
}

void nameObjects(BoundedRobot& objects) {
  for (auto* const problems : {&objects.problems, &objects.body_problems}) {
    for (std::string& problem : *problems) {
      for (const BoundedLink& object : objects.links) {
        const std::string name = "\"" + object.name + "\"";
        const std::string as_link = "link " + name + ", visual 1";
        if (problem.rfind(as_link, 0) != 0) continue;
        problem.replace(0, as_link.size(), "object " + name);
        break;
      }
    }
  }
}

}  // namespace link_bounds

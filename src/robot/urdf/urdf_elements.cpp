// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks sizes, scales and origins.
#include "robot/urdf/urdf_elements.h"

namespace link_bounds {
namespace {

/// Leaves solid and uri empty if the kind of geometry is unknown.
void setGeometry(const urdf::Geometry& geometry, Element& element) {
  if (geometry.type == urdf::Geometry::BOX) {
    element.solid = Solid::kBox;
    element.size = toVector(static_cast<const urdf::Box&>(geometry).dim);
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    element.solid = Solid::kEllipsoid;
    element.size.setConstant(2 * static_cast<const urdf::Sphere&>(geometry).radius);
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    element.solid = Solid::kCylinder;
    element.size = {2 * cylinder.radius, 2 * cylinder.radius, cylinder.length};
  } else if (geometry.type == urdf::Geometry::MESH) {
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    element.mesh_uri = mesh.filename;
    element.link_from_shape.linear() *= toVector(mesh.scale).asDiagonal();
  }
}

/// Why an element that urdfdom accepted cannot be used; "" if it can.
std::string faultOf(const Element& element) {
  if (element.solid == Solid::kNone && element.mesh_uri.empty()) {
    return "it names no mesh file and no known shape; add one";
  }
  if (!isUsablePose(element.link_from_shape)) {
    return "its origin or scale is not a finite number below 1e30; correct it";
  }
  if (!element.size.allFinite()) return "its size is not a finite number; correct it";
  if ((element.size.array() < 0).any()) return "its size is negative; make it positive";
  return "";
}

template <class UrdfElementSharedPtr>
void addElements(const std::vector<UrdfElementSharedPtr>& sources, Purpose purpose, Link& link) {
  std::size_t number = 0;
  for (const auto& source : sources) {
    Element element;
    element.purpose = purpose;
    element.number = ++number;
    element.link_from_shape = toIsometry(source->origin);
    if (source->geometry) setGeometry(*source->geometry, element);
    const std::string fault = faultOf(element);
    if (fault.empty()) {
      link.elements.push_back(element);
    } else {
      link.lost.push_back({purpose, number, fault});
    }
  }
}

}  // namespace

Eigen::Isometry3d toIsometry(const urdf::Pose& pose) {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  result.translation() = toVector(pose.position);
  return result;
}

Eigen::Vector3d toVector(const urdf::Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}

Link toLink(const urdf::Link& source) {
  Link link;
  link.name = source.name;
  addElements(source.visual_array, Purpose::kVisual, link);
  addElements(source.collision_array, Purpose::kCollision, link);
  return link;
}

}  // namespace link_bounds

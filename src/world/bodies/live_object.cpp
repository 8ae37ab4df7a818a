// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/bodies/live_object.h"

#include <algorithm>

namespace link_bounds {
namespace {

bool isSame(const Shape& a, const Shape& b) {
  if (!a.points != !b.points || (a.points && !a.points->isSame(*b.points))) return false;
  return a.solid == b.solid && a.size == b.size &&
         a.link_from_shape.matrix() == b.link_from_shape.matrix();
}

}  // namespace

void ObjectContent::setMesh(const LoadedMesh& mesh) {
  std::shared_ptr<const PointSet>& points = bounded.shapes.front().points;
  is_read_again = points && !mesh.points && mesh.error.empty();
  if (!is_read_again) points = mesh.points;
  bounded.missing =
      is_read_again ? "its mesh " + mesh_uri + " has changed and is still loading" : mesh.error;
}

bool isSameBody(const ObjectContent& a, const ObjectContent& b) {
  const std::vector<Shape>& shapes = b.bounded.shapes;
  return a.drawing == b.drawing &&
         std::equal(a.bounded.shapes.begin(), a.bounded.shapes.end(), shapes.begin(), shapes.end(),
                    [](const Shape& x, const Shape& y) { return isSame(x, y); });
}

bool isSame(const ObjectContent& a, const ObjectContent& b) {
  return a.frame == b.frame && a.stamp == b.stamp && a.mesh_uri == b.mesh_uri &&
         a.is_neighbour == b.is_neighbour && a.is_static == b.is_static &&
         a.bounded.missing == b.bounded.missing && a.refused_name == b.refused_name &&
         isSameBody(a, b);
}

std::string whyNameRefused(const LiveObject& other) {
  return std::string("its name is that of a ") + (other.content->is_neighbour ? "box" : "marker") +
         " of " + other.content->publisher + "; give one of them another name";
}

}  // namespace link_bounds

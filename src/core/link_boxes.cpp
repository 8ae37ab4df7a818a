// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The union of the boxes of a link's shapes.
#include "link_bounds/link_boxes.h"

#include <algorithm>

namespace link_bounds {

double magnitude(const BoundedLink& link) {
  double result = 0;
  for (const Shape& shape : link.shapes) {
    Eigen::Vector3d own = shape.size / 2;
    if (shape.points) own += shape.points->magnitude();
    const Eigen::Vector3d placed = shape.link_from_shape.linear().cwiseAbs() * own +
                                   shape.link_from_shape.translation().cwiseAbs();
    result = std::max(result, placed.maxCoeff());
  }
  return result;
}

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link,
                            LinkReach& reach) {
  if (link.shapes.empty()) return std::nullopt;
  Aabb box;
  for (std::size_t i = 0; i < link.shapes.size(); ++i) {
    const Shape& shape = link.shapes[i];
    ShapeReach& shape_reach = reach.shapes[i];
    const std::optional<Aabb> part =
        shape_reach.is_in_link_frame
            ? placedBox(shape, world_from_link, shape_reach)
            : placedBox(shape, world_from_link * shape.link_from_shape, shape_reach);
    if (!part) return std::nullopt;
    box.extend(*part);
  }
  return link.padding == 0 ? box : padded(box, link.padding);
}

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link) {
  LinkReach reach(link);
  return linkBox(link, world_from_link, reach);
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The box of one link, without a cache.
#include "link_bounds/geometry/shape/bounded_link.h"

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

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link) {
  std::optional<Aabb> result;
  for (const Shape& shape : link.shapes) {
    const std::optional<Aabb> box = worldBox(shape, world_from_link);
    if (!box) return std::nullopt;
    result = result ? result->merged(*box) : *box;
  }
  if (result && link.padding != 0) result = padded(*result, link.padding);
  return result;
}

}  // namespace link_bounds

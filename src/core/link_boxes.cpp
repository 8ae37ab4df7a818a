// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The union of the boxes of a link's shapes.
#include "link_bounds/link_boxes.h"

namespace link_bounds {

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link) {
  if (link.shapes.empty()) return std::nullopt;
  Aabb box;
  for (const Shape& shape : link.shapes) {
    const std::optional<Aabb> part = worldBox(shape, world_from_link);
    if (!part) return std::nullopt;
    box.extend(*part);
  }
  return padded(box, link.padding);
}

}  // namespace link_bounds

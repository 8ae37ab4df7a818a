// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a link is split into: its triangles and its shapes that are no mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "link_bounds/geometry/parts/part_tree.h"

namespace link_bounds {

/// Lengths are in units of the link's largest extent, so that no description of a robot, in
/// whatever unit, leaves the range of float. They decide where to split, and nothing else.
struct PartItem {
  Eigen::Vector3f low;   ///< box in the axes of the link
  Eigen::Vector3f high;  ///< as low
  float surface;         ///< of the triangle, or of the box of another shape
  std::uint32_t shape;
  std::uint32_t triangle;  ///< of the shape's mesh

  Eigen::Vector3f center() const { return (low + high) / 2; }
};

using PartItems = std::vector<PartItem>;

/// Nothing if a shape has no finite box or all of the link is one point.
std::optional<Eigen::Affine3d> unitFromLink(const std::vector<DivisibleShape>& shapes);

PartItems partItems(const std::vector<DivisibleShape>& shapes,
                    const Eigen::Affine3d& unit_from_link);

}  // namespace link_bounds

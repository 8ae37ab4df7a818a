// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A leaf of a tree during a search.
#pragma once

#include <algorithm>

#include "geometry/distance/triangle_tree.h"

namespace link_bounds {

/// The triangles of a leaf, and how far they extend along a direction.
class Leaf {
 public:
  Leaf(const TriangleTree& tree, std::uint32_t node, const Placement& at)
      : count(tree.nodes[node].count), tree_(tree), first_(tree.nodes[node].first), at_(at) {}

  void project(const Eigen::Vector3d& direction) {
    const Eigen::Vector3d d = at_.toShape(direction);
    const double origin = at_.translation.dot(direction);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& [a, b, c] = tree_.triangles[first_ + i];
      farthest[i] = origin + std::max({d.dot(tree_.vertices[a]), d.dot(tree_.vertices[b]),
                                       d.dot(tree_.vertices[c])});
    }
  }

  Triangle placed(std::uint32_t i) const {
    Triangle corners = tree_.corners(first_ + i);
    for (Eigen::Vector3d& corner : corners)
      corner = at_.toSearch(corner);
    return corners;
  }

  std::uint32_t count;
  std::array<double, kTrianglesPerLeaf> farthest;  ///< along the direction, from the origin

 private:
  const TriangleTree& tree_;
  std::uint32_t first_;
  const Placement& at_;
};

}  // namespace link_bounds

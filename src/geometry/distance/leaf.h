// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A leaf of a tree during a search.
#pragma once

#include <algorithm>

#include "geometry/distance/triangle_tree.h"

namespace link_bounds {

/// In the coordinates of a search.
inline Triangle placed(const TriangleTree& tree, std::uint32_t triangle, const Placement& at) {
  Triangle corners = tree.corners(triangle);
  for (Eigen::Vector3d& corner : corners)
    corner = at.toSearch(corner);
  return corners;
}

/// The triangles of a leaf, and how far they extend along a direction.
class Leaf {
 public:
  Leaf(const TriangleTree& tree, std::uint32_t node, const Placement& at)
      : count(tree.nodes[node].count), first(tree.nodes[node].first), tree_(tree), at_(at) {}

  /// Finds how far the triangles from `begin` to `end` extend along a direction. The others keep
  /// what they have of another one.
  void project(const Eigen::Vector3d& direction, std::uint32_t begin, std::uint32_t end) {
    const Eigen::Vector3d d = at_.toShape(direction);
    const double origin = at_.translation.dot(direction);
    for (std::uint32_t i = begin; i < end; ++i) {
      const auto& [a, b, c] = tree_.triangles[first + i];
      farthest[i] = origin + std::max({d.dot(tree_.vertices[a]), d.dot(tree_.vertices[b]),
                                       d.dot(tree_.vertices[c])});
    }
  }

  /// All must be projected on the same direction.
  double farthestOfAll() const {
    return *std::max_element(farthest.begin(), farthest.begin() + count);
  }

  Triangle placed(std::uint32_t i) const { return link_bounds::placed(tree_, first + i, at_); }

  std::uint32_t count;
  std::uint32_t first;                             ///< the index of the first one in the tree
  std::array<double, kTrianglesPerLeaf> farthest;  ///< along its last direction, from the origin

 private:
  const TriangleTree& tree_;
  const Placement& at_;
};

}  // namespace link_bounds

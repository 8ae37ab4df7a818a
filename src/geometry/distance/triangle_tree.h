// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A binary tree over triangles. Each node has an oriented box: long and thin triangles, of which
// CAD meshes consist, fill spheres and axis-aligned boxes badly.
#pragma once

#include "geometry/distance/convex_sets.h"
#include "geometry/distance/triangle_distance.h"
#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// The box holds all triangles of the node, each swept by the solid. Its edges are half edges.
struct TreeNode {
  Eigen::Vector3f center;
  std::array<Eigen::Vector3f, 3> edges;
  std::uint32_t first;  ///< the left child, or the first triangle of a leaf
  std::uint32_t count;  ///< of a leaf's triangles; 0: the right child follows the left one

  bool isLeaf() const { return count > 0; }

  Parallelepiped box() const {
    return {center.cast<double>(),
            {edges[0].cast<double>(), edges[1].cast<double>(), edges[2].cast<double>()}};
  }
};

/// A leaf has no more triangles.
constexpr std::size_t kTrianglesPerLeaf = 4;

class TriangleTree {
 public:
  std::vector<TreeNode> nodes;  ///< the root first
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Eigen::Vector3d> vertices;
  Solid solid = Solid::kNone;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  double magnitude = 0;  ///< no |coordinate| of any box exceeds it

  Triangle corners(std::size_t triangle) const {
    const auto& [a, b, c] = triangles[triangle];
    return {vertices[a], vertices[b], vertices[c]};
  }
};

}  // namespace link_bounds

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
  /// Not aligned, as the other members leave no room for that.
  using Lanes = Eigen::Array<float, 4, 1, Eigen::DontAlign>;

  /// Of the centre and the three edges. What is computed of all four at a time is dropped where it
  /// has no meaning for the centre.
  Lanes x, y, z;
  std::uint32_t first;  ///< triangle; those of a node follow each other
  std::uint32_t count;  ///< of triangles
  std::uint32_t child;  ///< the left one, which the right one follows; 0: a leaf
  /// Where the vertices of all its triangles begin, which follow each other. Only the largest of
  /// the small nodes have such a list; in all others the count is 0.
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;

  bool isLeaf() const { return child == 0; }

  Eigen::Vector3f center() const { return {x[0], y[0], z[0]}; }
  Eigen::Vector3f edge(int k) const { return {x[k + 1], y[k + 1], z[k + 1]}; }

  void setCenter(const Eigen::Vector3f& point) { set(0, point); }
  void setEdge(int k, const Eigen::Vector3f& vector) { set(k + 1, vector); }

  Parallelepiped box() const {
    return {center().cast<double>(),
            {edge(0).cast<double>(), edge(1).cast<double>(), edge(2).cast<double>()}};
  }

  /// How far the triangles extend from the centre along a direction: computed in floats, not less
  /// than that, as kEdgePad says (tree_build.cpp).
  double extent(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3f d = direction.cast<float>();
    return ((x * d.x() + y * d.y() + z * d.z()).abs() * edgesOnly()).sum();
  }

  /// The same from the origin of the shape.
  double farthest(const Eigen::Vector3d& direction) const {
    return center().cast<double>().dot(direction) + extent(direction);
  }

  /// Of the longest edge.
  float squaredRadius() const { return ((x * x + y * y + z * z) * edgesOnly()).maxCoeff(); }

  static Eigen::Array4f edgesOnly() { return {0, 1, 1, 1}; }

 private:
  void set(int lane, const Eigen::Vector3f& v) {
    x[lane] = v.x();
    y[lane] = v.y();
    z[lane] = v.z();
  }
};

/// A leaf has no more triangles.
constexpr std::size_t kTrianglesPerLeaf = 8;

/// A node with up to this many triangles is small: the search also compares the hulls of two. In
/// coherent motion 64 take 20 % more time for visual meshes of the Panda, 8 % for those of the PR2,
/// and from 2 % less to 20 % more for collision meshes.
constexpr std::uint32_t kSmallNode = 192;

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

/// True for a vertex that a triangle uses, and where a solid sweeps it, for all points of that
/// solid's box. Looks at each vertex.
bool holdsPoint(const TriangleTree& tree, const Eigen::Vector3d& point);

/// The convex hull of a node's triangles, each swept by the solid.
struct NodeHull {
  const TriangleTree& tree;
  const TreeNode& node;

  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d* best = &tree.vertices[tree.triangles[node.first][0]];
    double best_dot = best->dot(direction);
    const auto consider = [&](const Eigen::Vector3d& vertex) {
      const double dot = vertex.dot(direction);
      if (!(dot > best_dot)) return;
      best_dot = dot;
      best = &vertex;
    };
    if (node.vertex_count > 0) {
      for (std::uint32_t i = 0; i < node.vertex_count; ++i)
        consider(tree.vertices[node.first_vertex + i]);
    } else {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        for (const std::uint32_t vertex : tree.triangles[i])
          consider(tree.vertices[vertex]);
      }
    }
    if (tree.solid == Solid::kNone) return *best;
    return *best + farthestOf(tree.solid, tree.size, direction);
  }
};

}  // namespace link_bounds

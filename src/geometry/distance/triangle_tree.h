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

  /// Coordinates of the centre (lane 0) and of the three edges. All four are computed at a time;
  /// lane 0 is dropped where it has no meaning for the centre.
  Lanes x, y, z;
  std::uint32_t first;  ///< index of the first triangle; those of a node are contiguous
  std::uint32_t count;  ///< number of triangles
  std::uint32_t child;  ///< index of the left child; the right child comes next. 0: a leaf
  /// Index of the first vertex of the topmost small node that holds this one. The vertices of that
  /// node are contiguous.
  std::uint32_t first_vertex = 0;
  /// Index in hull_lists of the list of this node's hull vertices: their number, then their offsets
  /// from first_vertex. 0: no list, as for a leaf.
  std::uint32_t hull_list = 0;

  bool isLeaf() const { return child == 0; }

  Eigen::Vector3f center() const { return {x[0], y[0], z[0]}; }
  Eigen::Vector3f edge(int k) const { return {x[k + 1], y[k + 1], z[k + 1]}; }

  void setCenter(const Eigen::Vector3f& point) { set(0, point); }
  void setEdge(int k, const Eigen::Vector3f& vector) { set(k + 1, vector); }

  Parallelepiped box() const {
    return {center().cast<double>(),
            {edge(0).cast<double>(), edge(1).cast<double>(), edge(2).cast<double>()}};
  }

  /// How far the triangles extend from the centre along a direction. Computed in floats, but never
  /// too small, see kEdgePad in tree_build.cpp.
  double extent(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3f d = direction.cast<float>();
    return ((x * d.x() + y * d.y() + z * d.z()).abs() * edgesOnly()).sum();
  }

  /// The support of the box along a direction, from the origin of the shape.
  double farthest(const Eigen::Vector3d& direction) const {
    return center().cast<double>().dot(direction) + extent(direction);
  }

  /// The square of the longest edge [m^2].
  float squaredRadius() const { return ((x * x + y * y + z * z) * edgesOnly()).maxCoeff(); }

  static Eigen::Array4f edgesOnly() { return {0, 1, 1, 1}; }

 private:
  void set(int lane, const Eigen::Vector3f& v) {
    x[lane] = v.x();
    y[lane] = v.y();
    z[lane] = v.z();
  }
};

/// Max number of triangles of a leaf.
constexpr std::size_t kTrianglesPerLeaf = 8;

/// A node with up to this many triangles is small: the search also compares the convex hulls of two
/// small nodes. In coherent motion, 192 take 5 to 11 % more instructions for visual meshes of the
/// PR2 and the Panda, 1,024 take 2 to 13 % more; for collision meshes the difference is 1 %.
constexpr std::uint32_t kSmallNode = 384;

/// No vertex of a node is outside the hull of its listed vertices by more than this fraction of the
/// tree's magnitude.
constexpr double kHullPad = 0x1p-22;

class TriangleTree {
 public:
  std::vector<TreeNode> nodes;  ///< the root first
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Eigen::Vector3d> vertices;
  using Offset = std::uint16_t;
  std::vector<Offset> hull_lists;
  Solid solid = Solid::kNone;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  double magnitude = 0;  ///< no |coordinate| of any box exceeds it

  Triangle corners(std::size_t triangle) const {
    const auto& [a, b, c] = triangles[triangle];
    return {vertices[a], vertices[b], vertices[c]};
  }

  /// Calls `use` with the offset of each vertex that counts for the hull of a small node. Without a
  /// list, a vertex may come several times.
  template <class Use>
  void forEachHullVertex(const TreeNode& node, const Use& use) const {
    if (node.hull_list == 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        for (const std::uint32_t vertex : triangles[i])
          use(static_cast<Offset>(vertex - node.first_vertex));
      }
    } else {
      const Offset* const list = &hull_lists[node.hull_list];
      for (const Offset* offset = list + 1; offset != list + 1 + *list; ++offset)
        use(*offset);
    }
  }
};

/// True for a vertex of the tree and, if a solid sweeps the vertices, for all points of the solid's
/// box around one. Looks at each vertex.
bool holdsPoint(const TriangleTree& tree, const Eigen::Vector3d& point);

/// The convex hull of a small node's triangles, each swept by the solid, up to kHullPad.
struct NodeHull {
  const TriangleTree& tree;
  const TreeNode& node;

  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d* const vertices = &tree.vertices[node.first_vertex];
    const Eigen::Vector3d* best = vertices;
    double best_dot = -std::numeric_limits<double>::infinity();
    tree.forEachHullVertex(node, [&](TriangleTree::Offset offset) {
      const double dot = vertices[offset].dot(direction);
      if (!(dot > best_dot)) return;
      best_dot = dot;
      best = vertices + offset;
    });
    if (tree.solid == Solid::kNone) return *best;
    return *best + farthestOf(tree.solid, tree.size, direction);
  }
};

}  // namespace link_bounds

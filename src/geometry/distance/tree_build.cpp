// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Fits an oriented box to the triangles of a node and divides them along its longest edge.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/distance/hull_vertices.h"
#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

/// Max of vertices and sizes [m]: the products of two such lengths stay finite.
constexpr double kLargestCoordinate = 1e30;

/// Every box is larger than its triangles by this part of their distance from its centre. The axes
/// are unit and orthogonal to 1e-14, because fit() takes no others, and rounding a half edge to
/// float turns and shortens it by at most 6e-8 of its length. In the basis of the rounded edges, a
/// coordinate of a point so differs from the one along the axes by at most 1.1e-7 of the point's
/// distance from the centre. TreeNode::extent() along d is then too small by at most 7.3e-7 |d| of
/// that distance: with v = 2^-24, each product of an edge e and d loses 4 v |e| |d| to the rounding
/// of d, of three products and two sums, the sum over the edges 3 v more, and the edges add up to
/// at most sqrt(3) of the distance. The pad adds 1e-6 |d| or more, since the absolute values of the
/// coordinates of d along the axes add up to |d| or more.
constexpr double kEdgePad = 1e-6;

/// Nodes with up to this many triangles also try the axes of each triangle.
constexpr std::uint32_t kFewTriangles = 16;

/// Smaller boxes would lose digits to underflow [m].
constexpr double kSmallestRadius = 1e-30;

/// Cost of a node per triangle, see WorkMeter: its box is fitted along two sets of axes, or along
/// more if it has few triangles.
constexpr std::size_t kLooksPerTriangle = 10;

using Axes = Eigen::Matrix3d;  // columns

struct FittedBox {
  Axes axes = Axes::Identity();
  Aabb box;  ///< of the triangles, in coordinates along the axes

  double surface() const {
    const Eigen::Vector3d size = box.sizes();
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  }
};

class Builder {
 public:
  Builder(TriangleTree& tree, WorkMeter& meter) : tree_(tree), meter_(meter) {}

  void build() {
    tree_.nodes.emplace_back();
    std::vector<Range> open{{0, 0, static_cast<std::uint32_t>(tree_.triangles.size())}};
    while (!open.empty()) {
      const Range range = open.back();
      open.pop_back();
      meter_.add(kLooksPerTriangle * (range.end - range.begin));
      const FittedBox box = fit(range);
      store(box, range);
      if (range.end - range.begin > kTrianglesPerLeaf) divide(box, range, open);
    }
  }

 private:
  struct Range {
    std::uint32_t node, begin, end;  ///< triangles
  };

  FittedBox along(const Axes& axes, const Range& range) const {
    FittedBox result{axes, Aabb()};
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      for (const Eigen::Vector3d& corner : tree_.corners(i))
        result.box.extend(axes.transpose() * corner);
    }
    return result;
  }

  /// The axes of min and max variance of the area, as Gottschalk, Lin and Manocha (1996) take
  /// them.
  Axes principalAxes(const Range& range) const {
    const Eigen::Vector3d origin = tree_.corners(range.begin)[0];
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      Triangle p = tree_.corners(i);
      for (Eigen::Vector3d& corner : p)
        corner -= origin;
      const double area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
      const Eigen::Vector3d center = (p[0] + p[1] + p[2]) / 3;
      moments += area / 12 *
                 (9 * center * center.transpose() + p[0] * p[0].transpose() +
                  p[1] * p[1].transpose() + p[2] * p[2].transpose());
      sum += area * center;
      total += area;
    }
    moments -= sum * sum.transpose() / total;
    const double scale = moments.cwiseAbs().maxCoeff();
    if (!std::isnormal(scale)) return Axes::Identity();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments / scale);
    return solver.info() == Eigen::Success ? Axes(solver.eigenvectors()) : Axes::Identity();
  }

  /// Axes along the longest edge of the triangle and across its plane.
  Axes triangleAxes(std::uint32_t triangle) const {
    const Triangle p = tree_.corners(triangle);
    std::array<Eigen::Vector3d, 3> edges{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
    std::sort(edges.begin(), edges.end(),
              [](const auto& a, const auto& b) { return a.squaredNorm() > b.squaredNorm(); });
    const Eigen::Vector3d x = edges[0].normalized();
    const Eigen::Vector3d z = x.cross(edges[1].normalized()).normalized();
    Axes axes;
    axes << x, z.cross(x), z;
    return axes;
  }

  FittedBox fit(const Range& range) const {
    FittedBox best = along(Axes::Identity(), range);
    const auto consider = [&](const Axes& axes) {
      // Also refuses NaN, which a triangle without a direction gives.
      if (!((axes.transpose() * axes - Axes::Identity()).cwiseAbs().maxCoeff() < 1e-14)) return;
      const FittedBox box = along(axes, range);
      if (box.surface() < best.surface()) best = box;
    };
    consider(principalAxes(range));
    if (range.end - range.begin <= kFewTriangles) {
      for (std::uint32_t i = range.begin; i < range.end; ++i)
        consider(triangleAxes(i));
    }
    return best;
  }

  void store(const FittedBox& fitted, const Range& range) {
    TreeNode& node = tree_.nodes[range.node];
    node.setCenter((fitted.axes * fitted.box.center()).cast<float>());
    const Eigen::Vector3d center = fitted.axes.transpose() * node.center().cast<double>();
    Eigen::Vector3d half =
        (fitted.box.max() - center).cwiseMax(center - fitted.box.min()).cwiseMax(0.0);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = fitted.axes.col(k);
      half[k] += axis.dot(farthestOf(tree_.solid, tree_.size, axis));
    }
    const double radius = std::max(length(half.x(), half.y(), half.z()), kSmallestRadius);
    half.array() += kEdgePad * radius;
    double magnitude = 0;
    for (int k = 0; k < 3; ++k) {
      node.setEdge(k, (fitted.axes.col(k) * half[k]).cast<float>());
      magnitude += node.edge(k).cast<double>().cwiseAbs().maxCoeff();
    }
    magnitude += node.center().cast<double>().cwiseAbs().maxCoeff();
    tree_.magnitude = std::max(tree_.magnitude, magnitude);
    node.first = range.begin;
    node.count = range.end - range.begin;
    node.child = 0;
  }

  /// Divides at the mean of the triangles' centres along the box's longest edge, or in the middle
  /// of the list if that separates nothing.
  void divide(const FittedBox& box, const Range& range, std::vector<Range>& open) {
    int longest = 0;
    box.box.sizes().maxCoeff(&longest);
    const Eigen::Vector3d axis = box.axes.col(longest);
    const auto position = [&](const std::array<std::uint32_t, 3>& t) {
      return axis.dot(tree_.vertices[t[0]]) + axis.dot(tree_.vertices[t[1]]) +
             axis.dot(tree_.vertices[t[2]]);
    };
    const auto begin = tree_.triangles.begin() + range.begin;
    const auto end = tree_.triangles.begin() + range.end;
    double sum = 0;
    for (auto i = begin; i != end; ++i)
      sum += position(*i);
    const double mean = sum / static_cast<double>(end - begin);
    auto middle = std::partition(begin, end, [&](const auto& t) { return position(t) < mean; });
    if (middle == begin || middle == end) middle = begin + (end - begin) / 2;
    const auto border = static_cast<std::uint32_t>(middle - tree_.triangles.begin());
    const auto left = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.resize(tree_.nodes.size() + 2);
    tree_.nodes[range.node].child = left;
    open.push_back({left + 1, border, range.end});
    open.push_back({left, range.begin, border});
  }

  TriangleTree& tree_;
  WorkMeter& meter_;
};

/// Stores the vertices of each topmost small node in one contiguous block. A vertex that several of
/// these nodes use is stored in each block.
class VertexBlocks {
 public:
  VertexBlocks(TriangleTree& tree, WorkMeter& meter)
      : tree_(tree), moved_to_(tree.vertices.size(), 0) {
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      TreeNode& node = tree.nodes[open.back()];
      open.pop_back();
      if (node.count <= kSmallNode) {
        meter.add(kLooksPerTriangle * node.count);
        gather(node);
      } else {
        open.push_back(node.child + 1);
        open.push_back(node.child);
      }
    }
    vertices_.shrink_to_fit();
    tree.vertices = std::move(vertices_);
  }

 private:
  void gather(TreeNode& node) {
    setFirstVertex(node, static_cast<std::uint32_t>(vertices_.size()));
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      for (std::uint32_t& vertex : tree_.triangles[i]) {
        std::uint32_t& after = moved_to_[vertex];
        if (after <= node.first_vertex) {
          vertices_.push_back(tree_.vertices[vertex]);
          after = static_cast<std::uint32_t>(vertices_.size());
        }
        vertex = after - 1;
      }
    }
  }

  /// Sets first_vertex of the node and of all nodes below.
  void setFirstVertex(TreeNode& node, std::uint32_t vertex) {
    node.first_vertex = vertex;
    if (node.isLeaf()) return;
    setFirstVertex(tree_.nodes[node.child], vertex);
    setFirstVertex(tree_.nodes[node.child + 1], vertex);
  }

  TriangleTree& tree_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::uint32_t> moved_to_;  ///< by old index: the new index plus 1
};

bool isUsable(const std::vector<Eigen::Vector3d>& vertices,
              const std::vector<std::array<std::uint32_t, 3>>& triangles,
              const Eigen::Vector3d& size) {
  if (triangles.empty() || triangles.size() > (1u << 30)) return false;
  const auto isSmall = [](const Eigen::Vector3d& v) {
    return (v.array().abs() <= kLargestCoordinate).all();
  };
  if (!isSmall(size) || !std::all_of(vertices.begin(), vertices.end(), isSmall)) return false;
  return std::all_of(triangles.begin(), triangles.end(), [&](const auto& triangle) {
    return *std::max_element(triangle.begin(), triangle.end()) < vertices.size();
  });
}

}  // namespace

std::shared_ptr<const TriangleTree> triangleTree(
    const std::vector<Eigen::Vector3d>& vertices,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, Solid solid,
    const Eigen::Vector3d& size, const CheckInterrupt& check_interrupt) {
  if (!isUsable(vertices, triangles, size)) return nullptr;
  auto tree = std::make_shared<TriangleTree>();
  tree->vertices = vertices;
  tree->triangles = triangles;
  tree->solid = solid;
  tree->size = size;
  WorkMeter meter(check_interrupt);
  Builder(*tree, meter).build();
  VertexBlocks(*tree, meter);
  listHullVertices(*tree, meter);
  tree->nodes.shrink_to_fit();
  return tree;
}

std::shared_ptr<const TriangleTree> triangleTree(const TriangleMesh& mesh,
                                                 const CheckInterrupt& check_interrupt) {
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    vertices.push_back(vertex.cast<double>());
  return triangleTree(vertices, mesh.triangles, Solid::kNone, Eigen::Vector3d::Zero(),
                      check_interrupt);
}

bool holdsPoint(const TriangleTree& tree, const Eigen::Vector3d& point) {
  // Rounding may take the sum of a vertex and half a size outside.
  const Eigen::Array3d half = tree.size.array().abs() / 2 + 8 * kUnitRoundoff * tree.magnitude;
  return std::any_of(tree.vertices.begin(), tree.vertices.end(), [&](const auto& vertex) {
    return ((point - vertex).array().abs() <= half).all();
  });
}

std::size_t bytes(const TriangleTree& tree) {
  return sizeof(tree) + tree.nodes.capacity() * sizeof(TreeNode) +
         tree.triangles.capacity() * sizeof(tree.triangles[0]) +
         tree.vertices.capacity() * sizeof(tree.vertices[0]) +
         tree.hull_lists.capacity() * sizeof(tree.hull_lists[0]);
}

/// Counts as many nodes as if each leaf had one triangle.
std::size_t maxTreeBytes(const TriangleMesh& mesh) {
  return sizeof(TriangleTree) +
         mesh.triangles.size() * (2 * sizeof(TreeNode) + sizeof(mesh.triangles[0]) + kListedBytes) +
         mesh.vertices.size() * sizeof(Eigen::Vector3d);
}

}  // namespace link_bounds

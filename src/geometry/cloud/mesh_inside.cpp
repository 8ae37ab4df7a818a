// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cloud/mesh_inside.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/distance/triangle_tree.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kOpen = static_cast<std::uint32_t>(-1);

/// The error of a triple product, relative to the product of the three lengths: less than 20
/// operations, each wrong by 1.2e-16.
constexpr double kProductError = 1e-14;

/// Directions of rays. None is a typical axis of a CAD model, and no two of them lie in one plane
/// with such an axis.
const std::array<Eigen::Vector3d, 8> kDirections{{{0.5773, 0.3917, 0.7164},
                                                  {-0.6121, 0.4409, 0.6565},
                                                  {0.2297, -0.8821, 0.4113},
                                                  {-0.3319, -0.2711, -0.9036},
                                                  {0.9173, 0.1291, -0.3767},
                                                  {-0.8147, -0.5591, 0.1543},
                                                  {0.1013, 0.7723, -0.6271},
                                                  {0.4729, -0.3389, -0.8133}}};

/// Vertices of a tree that have the same coordinates get the same number.
std::vector<std::uint32_t> weldedVertices(const TriangleTree& tree) {
  std::vector<std::uint32_t> order(tree.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const Eigen::Vector3d& v = tree.vertices[i];
    return std::make_tuple(v.x(), v.y(), v.z());
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<std::uint32_t> result(order.size());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && key(order[i - 1]) < key(order[i])) ++number;
    result[order[i]] = number;
  }
  return result;
}

using Corners = std::array<std::uint32_t, 3>;

/// The vertices of each triangle by their new numbers.
std::vector<Corners> weldedTriangles(const TriangleTree& tree) {
  const std::vector<std::uint32_t> welded = weldedVertices(tree);
  std::vector<Corners> result;
  result.reserve(tree.triangles.size());
  for (const auto& [a, b, c] : tree.triangles)
    result.push_back({welded[a], welded[b], welded[c]});
  return result;
}

std::vector<Corners> inOrder(std::vector<Corners> triangles) {
  for (Corners& corners : triangles)
    std::sort(corners.begin(), corners.end());
  return triangles;
}

/// How often each triangle occurs; the vertices of each must be sorted. The count is at the first
/// of equal triangles, 0 at the others. It is 0 also for a triangle that is a line or a point,
/// which no ray crosses.
std::vector<std::uint32_t> copiesOf(const std::vector<Corners>& triangles) {
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::tie(triangles[a], a) < std::tie(triangles[b], b); });
  std::vector<std::uint32_t> result(triangles.size(), 0);
  std::uint32_t first = 0;
  for (const std::uint32_t i : order) {
    const auto& [a, b, c] = triangles[i];
    if (a == b || b == c) continue;
    if (triangles[first] != triangles[i] || result[first] == 0) first = i;
    ++result[first];
  }
  return result;
}

/// An edge of a triangle, with the smaller vertex first.
struct Edge {
  std::uint32_t first, second, triangle;
  int way;  ///< 1 if the triangle has its vertices in that order, else -1
  bool operator<(const Edge& other) const {
    return std::tie(first, second) < std::tie(other.first, other.second);
  }
};

/// The edges of all triangles whose count in `copies` is not 0, sorted.
std::vector<Edge> sortedEdges(const std::vector<Corners>& triangles,
                              const std::vector<std::uint32_t>& copies) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (copies[i] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[i][k], to = triangles[i][(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), i, from < to ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Disjoint sets of triangles (union-find).
class Parts {
 public:
  explicit Parts(std::size_t triangles) : parents_(triangles) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t triangle) {
    while (parents_[triangle] != triangle)
      triangle = parents_[triangle] = parents_[parents_[triangle]];
    return triangle;
  }

  void join(std::uint32_t a, std::uint32_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parents_;
};

/// True if the ray may hit the box of the node. The edges are orthogonal to 1e-7, and the box is
/// larger than its triangles by more than that; see kEdgePad in tree_build.cpp.
bool mayHit(const TreeNode& node, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d origin = from - node.center().cast<double>();
  double begin = 0, end = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d edge = node.edge(k).cast<double>();
    const double place = edge.dot(origin), step = edge.dot(direction);
    const double half = edge.squaredNorm() * (1 + 1e-9);
    if (step == 0) {
      if (std::abs(place) > half) return false;
      continue;
    }
    const auto [near, far] = std::minmax({(-half - place) / step, (half - place) / step});
    begin = std::max(begin, near);
    end = std::min(end, far);
  }
  return begin <= end * (1 + 1e-9);
}

}  // namespace

MeshInside::MeshInside(const TriangleTree& tree)
    : tree_(tree), parts_(tree.triangles.size(), kOpen) {
  const std::vector<Corners> triangles = weldedTriangles(tree);
  const std::vector<std::uint32_t> copies = copiesOf(inOrder(triangles));
  const std::vector<Edge> edges = sortedEdges(triangles, copies);
  Parts parts(triangles.size());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!(edges[i - 1] < edges[i])) parts.join(edges[i - 1].triangle, edges[i].triangle);
  }
  std::vector<std::uint32_t> bits(triangles.size(), 0);  // by part, of all counts
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    bits[parts.find(i)] |= copies[i];
  // Whether the count is odd, after all counts of the part were halved as often as possible.
  const auto is_odd = [&](std::uint32_t triangle) {
    const std::uint32_t all = bits[parts.find(triangle)];
    return (copies[triangle] & all & -all) != 0;
  };
  std::vector<bool> is_odd_open(triangles.size(), false), is_open = is_odd_open;
  is_oriented_.assign(triangles.size(), true);
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto end = std::upper_bound(edge, edges.end(), *edge);
    const auto odd = std::count_if(edge, end, [&](const Edge& e) { return is_odd(e.triangle); });
    const std::uint32_t part = parts.find(edge->triangle);
    is_odd_open[part] = is_odd_open[part] || odd % 2 != 0;
    is_open[part] = is_open[part] || (end - edge) % 2 != 0;
    int way = 0;
    for (; edge != end; ++edge) {
      way += edge->way;
      is_oriented_[part] = is_oriented_[part] && copies[edge->triangle] == 1;
    }
    is_oriented_[part] = is_oriented_[part] && way == 0;
  }
  for (std::uint32_t i = 0; i < parts_.size(); ++i) {
    const std::uint32_t part = parts.find(i);
    if (copies[i] == 0 || !(is_odd_open[part] ? !is_open[part] : is_odd(i))) continue;
    parts_[i] = part;
    has_inside_ = true;
  }
}

std::optional<bool> MeshInside::contains(const Eigen::Vector3d& point) const {
  if (!hasInside()) return false;
  std::vector<Crossed> crossed;
  for (const Eigen::Vector3d& direction : kDirections) {
    crossed.clear();
    if (!cast(point, direction, crossed)) continue;
    std::sort(crossed.begin(), crossed.end(),
              [](const Crossed& a, const Crossed& b) { return a.part < b.part; });
    for (auto at = crossed.begin(); at != crossed.end();) {
      const std::uint32_t part = at->part;
      int count = 0, winding = 0;
      for (; at != crossed.end() && at->part == part; ++at, ++count)
        winding += at->side;
      if (count % 2 != 0 || (is_oriented_[part] && winding != 0)) return true;
    }
    return false;
  }
  return std::nullopt;
}

bool MeshInside::crosses(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const Eigen::Vector3d way = to - from;
  bool is_crossed = false;
  visitAlong(from, way, [&](std::uint32_t triangle) {
    is_crossed = isCrossed(cross(triangle, from, way)) && isCrossed(cross(triangle, to, -way));
    return !is_crossed;
  });
  return is_crossed;
}

bool MeshInside::cast(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                      std::vector<Crossed>& crossed) const {
  return visitAlong(from, direction, [&](std::uint32_t triangle) {
    if (parts_[triangle] == kOpen) return true;
    const Crossing crossing = cross(triangle, from, direction);
    if (isCrossed(crossing))
      crossed.push_back({parts_[triangle], crossing == Crossing::kLeft ? 1 : -1});
    return crossing != Crossing::kUnsure;
  });
}

/// Calls `visit` for all triangles in leaves whose boxes the ray may hit. Ends with false as soon
/// as `visit` returns false.
template <class Visit>
bool MeshInside::visitAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                            const Visit& visit) const {
  std::array<std::uint32_t, 128> open;
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const TreeNode& node = tree_.nodes[open[--count]];
    if (!mayHit(node, from, direction)) continue;
    if (!node.isLeaf()) {
      if (count + 2 > open.size()) return false;
      open[count++] = node.child + 1;
      open[count++] = node.child;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!visit(i)) return false;
    }
  }
  return true;
}

/// The ray crosses the triangle if it passes all three edges on the same side and the plane of the
/// triangle lies ahead.
MeshInside::Crossing MeshInside::cross(std::size_t triangle, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) const {
  Triangle corners = tree_.corners(triangle);
  const double rounding = kProductError * (from.cwiseAbs().maxCoeff() + tree_.magnitude);
  for (Eigen::Vector3d& corner : corners)
    corner -= from;
  bool has_left = false, has_right = false, is_unsure = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& a = corners[k];
    const Eigen::Vector3d& b = corners[(k + 1) % 3];
    const double side = direction.dot(a.cross(b));
    const double error =
        (rounding + kProductError * a.norm()) * (b.norm() + rounding) + rounding * a.norm();
    has_left |= side > error;
    has_right |= side < -error;
    is_unsure |= std::abs(side) <= error;
  }
  if (has_left && has_right) return Crossing::kNo;
  if (is_unsure) return Crossing::kUnsure;
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double height = normal.dot(corners[0]);
  const double length = corners[0].norm() + corners[1].norm() + corners[2].norm();
  if (std::abs(height) <= (kProductError * length + rounding) * length * length)
    return Crossing::kUnsure;
  if ((height > 0) != has_left) return Crossing::kNo;
  return has_left ? Crossing::kLeft : Crossing::kRight;
}

}  // namespace link_bounds

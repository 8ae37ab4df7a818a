// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The search in a mesh goes into the nearer child first, and leaves out what cannot be nearer.
#include "geometry/cloud/body_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {
namespace {

/// Of a computed distance, relative to the largest coordinate: less than 50 operations, each wrong
/// by 1.2e-16.
constexpr double kRounding = 1e-14;

constexpr double kSolidAccuracy = 5e-7;  // m

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A lower bound of the distance of the point from the box: how far the plane across the way to the
/// nearest point of the box is from the box. It holds for edges that are not quite orthogonal, too.
double distanceOf(const TreeNode& node, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from = point - node.center.cast<double>();
  Eigen::Vector3d rest = from;
  std::array<Eigen::Vector3d, 3> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = node.edges[k].cast<double>();
    const double squared = edges[k].squaredNorm();
    if (squared > 0) rest -= std::clamp(edges[k].dot(from) / squared, -1.0, 1.0) * edges[k];
  }
  const double length = rest.norm();
  if (!(length > 0)) return 0;
  double gap = rest.dot(from);
  for (const Eigen::Vector3d& edge : edges)
    gap -= std::abs(rest.dot(edge));
  return gap / length;
}

Eigen::Vector3d nearestOnSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& point) {
  const Eigen::Vector3d edge = b - a;
  const double squared = edge.squaredNorm();
  const double along = (point - a).dot(edge);
  if (!(along > 0 && squared > 0)) return a;
  return along >= squared ? b : Eigen::Vector3d(a + (along / squared) * edge);
}

/// A convex combination of the corners; the nearest one but for rounding.
Eigen::Vector3d nearestOnTriangle(const Triangle& t, const Eigen::Vector3d& point) {
  const Eigen::Vector3d u = t[1] - t[0], v = t[2] - t[0], from = point - t[0];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  const double pu = from.dot(u), pv = from.dot(v);
  const double s = vv * pu - uv * pv, r = uu * pv - uv * pu;
  const bool is_thin = !(determinant > 1e-8 * uu * vv);
  Eigen::Vector3d best = t[0];
  double best_squared = from.squaredNorm();
  const auto offer = [&](const Eigen::Vector3d& other) {
    const double squared = (point - other).squaredNorm();
    if (!(squared < best_squared)) return;
    best = other;
    best_squared = squared;
  };
  if (s > 0 && r > 0 && s + r < determinant) {
    offer(t[0] + (s / determinant) * u + (r / determinant) * v);
    if (!is_thin) return best;
  }
  for (std::size_t k = 0; k < 3; ++k)
    offer(nearestOnSegment(t[k], t[(k + 1) % 3], point));
  return best;
}

/// The plane through the nearest point, across the way to it, has the triangle behind it.
PointDistance distanceOf(const Triangle& triangle, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = point - nearestOnTriangle(triangle, point);
  const double length = way.norm();
  if (!(length > 0)) return {0, 0};
  double gap = kInfinity;
  for (const Eigen::Vector3d& corner : triangle)
    gap = std::min(gap, way.dot(point - corner));
  return {std::max(gap / length, 0.0), length};
}

/// Branch and bound in one tree.
class PointSearch {
 public:
  PointSearch(const TriangleTree& tree, const Eigen::Vector3d& point, double near,
              PointDistance& best)
      : tree_(tree), point_(point), near_(near), best_(best) {}

  /// False once `upper` is at most `near`.
  bool visit(std::uint32_t index) {
    const TreeNode& node = tree_.nodes[index];
    if (node.isLeaf()) return visitLeaf(node);
    std::array<std::uint32_t, 2> children{node.child, node.child + 1};
    std::array<double, 2> bounds{distanceOf(tree_.nodes[children[0]], point_),
                                 distanceOf(tree_.nodes[children[1]], point_)};
    if (bounds[1] < bounds[0]) {
      std::swap(children[0], children[1]);
      std::swap(bounds[0], bounds[1]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (bounds[i] < std::min(best_.lower, best_.upper) && !visit(children[i])) return false;
    }
    return true;
  }

 private:
  bool visitLeaf(const TreeNode& node) {
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const PointDistance found = distanceOf(tree_.corners(i), point_);
      best_.lower = std::min(best_.lower, found.lower);
      best_.upper = std::min(best_.upper, found.upper);
    }
    return !(best_.upper <= near_);
  }

  const TriangleTree& tree_;
  const Eigen::Vector3d& point_;
  double near_;
  PointDistance& best_;
};

}  // namespace

BodySurface::BodySurface(const Body& body, const CheckInterrupt& check_interrupt) {
  for (const BodyShape& shape : body.shapes) {
    if (shape.triangles && shape.triangles->solid == Solid::kNone) {
      addMesh(shape, check_interrupt);
    } else {
      solids_.shapes.push_back(shape);
    }
    const auto box = worldBox(shape.shape, Eigen::Affine3d::Identity());
    if (box) box_.extend(*box);
    if (shape.tip) box_.extend(shape.shape.link_from_shape * *shape.tip);
  }
}

void BodySurface::addMesh(const BodyShape& shape, const CheckInterrupt& check_interrupt) {
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(shape.triangles->vertices.size());
  for (const Eigen::Vector3d& vertex : shape.triangles->vertices)
    vertices.push_back(shape.shape.link_from_shape * vertex);
  auto tree = triangleTree(vertices, shape.triangles->triangles, Solid::kNone,
                           Eigen::Vector3d::Zero(), check_interrupt);
  if (!tree) return;  // not finite in this pose: such a shape has no box either
  MeshInside inside(*tree);
  meshes_.push_back({std::move(tree), std::move(inside)});
}

PointDistance BodySurface::distance(const Eigen::Vector3d& point, double limit, double near) const {
  PointDistance best{limit, kInfinity};
  if (!solids_.shapes.empty()) {
    static const Body kPoint{{BodyShape()}};
    const Eigen::Affine3d at(Eigen::Translation3d{point});
    DistanceGoal goal{kSolidAccuracy, limit};
    const auto found = bodyDistance(solids_, Eigen::Affine3d::Identity(), kPoint, at, goal);
    if (found) best = {std::min(found->lower, limit), found->upper};
    if (best.upper <= near) return best;
  }
  const double point_size = point.cwiseAbs().maxCoeff();
  for (const Mesh& mesh : meshes_) {
    const double rounding = kRounding * (point_size + mesh.tree->magnitude);
    PointDistance found{best.lower + rounding, best.upper};
    const bool is_complete = PointSearch(*mesh.tree, point, near - rounding, found).visit(0);
    best.upper = std::min(best.upper, found.upper + rounding);
    if (!is_complete) return {0, best.upper};
    best.lower = std::min(best.lower, std::max(found.lower - rounding, 0.0));
  }
  return best;
}

bool BodySurface::contains(const Eigen::Vector3d& point) const {
  return std::any_of(meshes_.begin(), meshes_.end(),
                     [&](const Mesh& mesh) { return mesh.inside.contains(point); });
}

bool BodySurface::hasInside() const {
  return std::any_of(meshes_.begin(), meshes_.end(),
                     [](const Mesh& mesh) { return mesh.inside.hasInside(); });
}

std::size_t BodySurface::bytes() const {
  std::size_t sum = 0;
  for (const Mesh& mesh : meshes_)
    sum += link_bounds::bytes(*mesh.tree);
  return sum;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The search in a mesh goes into the nearer child first, and skips nodes that cannot hold a nearer
// point.
#include "geometry/cloud/body_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {
namespace {

/// Max error of a computed distance, relative to the largest coordinate: less than 50 operations,
/// each wrong by 1.2e-16.
constexpr double kRounding = 1e-14;

constexpr double kSolidAccuracy = 5e-7;  // m

/// The shortest step through a solid, and the max number of steps.
constexpr double kSolidStep = 5e-4;  // m
constexpr int kMaxSolidSteps = 10000;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A lower bound of the distance of the point from the box: the gap between both along the line
/// from the nearest point of the box to the point. It also holds if the edges are not quite
/// orthogonal.
double distanceOf(const TreeNode& node, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from = point - node.center().cast<double>();
  Eigen::Vector3d rest = from;
  std::array<Eigen::Vector3d, 3> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = node.edge(static_cast<int>(k)).cast<double>();
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

/// The lower bound is the gap along the line from `nearest` to the point. It holds even if rounding
/// has moved `nearest`.
PointDistance distanceOf(const Triangle& triangle, const Eigen::Vector3d& point,
                         const Eigen::Vector3d& nearest) {
  const Eigen::Vector3d way = point - nearest;
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
  bool look(std::uint32_t triangle) {
    const Triangle corners = tree_.corners(triangle);
    const Eigen::Vector3d place = nearestOnTriangle(corners, point_);
    const PointDistance found = distanceOf(corners, point_, place);
    if (found.upper < best_.upper) {
      nearest_ = triangle;
      place_ = place;
    }
    best_.lower = std::min(best_.lower, found.lower);
    best_.upper = std::min(best_.upper, found.upper);
    return !(best_.upper <= near_);
  }

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

  /// The nearest triangle that look() saw; 0 if none is nearer than the upper bound at the start.
  std::uint32_t nearest() const { return nearest_; }
  const Eigen::Vector3d& place() const { return place_; }

 private:
  bool visitLeaf(const TreeNode& node) {
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!look(i)) return false;
    }
    return true;
  }

  const TriangleTree& tree_;
  const Eigen::Vector3d& point_;
  double near_;
  PointDistance& best_;
  std::uint32_t nearest_ = 0;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
};

std::optional<BodyDistance> solidDistance(const Body& solids, const Eigen::Vector3d& point,
                                          double limit = kInfinity) {
  static const Body kPoint{{BodyShape()}};
  const Eigen::Affine3d at(Eigen::Translation3d{point});
  return bodyDistance(solids, Eigen::Affine3d::Identity(), kPoint, at, {kSolidAccuracy, limit});
}

std::shared_ptr<const TriangleTree> placedTree(const TriangleTree& tree,
                                               const Eigen::Affine3d& pose,
                                               const CheckInterrupt& check_interrupt) {
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(tree.vertices.size());
  for (const Eigen::Vector3d& vertex : tree.vertices)
    vertices.push_back(pose * vertex);
  return triangleTree(vertices, tree.triangles, Solid::kNone, Eigen::Vector3d::Zero(),
                      check_interrupt);
}

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
    is_whole_ = is_whole_ && box;
    if (shape.tip) box_.extend(shape.shape.link_from_shape * *shape.tip);
  }
}

void BodySurface::addMesh(const BodyShape& shape, const CheckInterrupt& check_interrupt) {
  std::shared_ptr<const TriangleTree> tree = shape.triangles;
  if (!shape.shape.link_from_shape.matrix().isIdentity(0))
    tree = placedTree(*tree, shape.shape.link_from_shape, check_interrupt);
  if (!tree) {  // not finite in this pose
    is_whole_ = false;
    return;
  }
  MeshInside inside(*tree);
  meshes_.push_back({std::move(tree), std::move(inside)});
}

PointDistance BodySurface::distance(const Eigen::Vector3d& point, double limit, double near,
                                    Hint* hint) const {
  PointDistance best{limit, kInfinity};
  if (!solids_.shapes.empty()) {
    const auto found = solidDistance(solids_, point, limit);
    if (found) best = {std::min(found->lower, limit), found->upper};
    if (best.upper <= near) return best;
  }
  const double point_size = point.cwiseAbs().maxCoeff();
  if (hint) hint->resize(meshes_.size(), 0);
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const TriangleTree& tree = *meshes_[i].tree;
    const double rounding = kRounding * (point_size + tree.magnitude);
    PointDistance found{best.lower + rounding, best.upper};
    PointSearch search(tree, point, near - rounding, found);
    const bool is_complete = (!hint || search.look((*hint)[i])) && search.visit(0);
    if (hint) (*hint)[i] = search.nearest();
    best.upper = std::min(best.upper, found.upper + rounding);
    if (!is_complete) return {0, best.upper};
    best.lower = std::min(best.lower, std::max(found.lower - rounding, 0.0));
  }
  return best;
}

SurfacePoint BodySurface::nearest(const Eigen::Vector3d& point) const {
  SurfacePoint best{{kInfinity, kInfinity}, point, false};
  if (!solids_.shapes.empty()) {
    if (const auto found = solidDistance(solids_, point))
      best = {{found->lower, found->upper}, found->on_first, found->level == DistanceLevel::kMesh};
  }
  const double point_size = point.cwiseAbs().maxCoeff();
  for (const Mesh& mesh : meshes_) {
    const double rounding = kRounding * (point_size + mesh.tree->magnitude);
    PointDistance found{best.distance.lower + rounding, best.distance.upper};
    PointSearch search(*mesh.tree, point, -1, found);
    search.visit(0);
    best.distance.lower = std::min(best.distance.lower, std::max(found.lower - rounding, 0.0));
    if (!(found.upper < best.distance.upper)) continue;
    best.distance.upper = found.upper + rounding;
    best.on_body = search.place();
    best.is_of_mesh = true;
  }
  return best;
}

bool BodySurface::crosses(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  return std::any_of(meshes_.begin(), meshes_.end(),
                     [&](const Mesh& mesh) { return mesh.inside.crosses(from, to); }) ||
         crossesSolid(from, to);
}

/// Each step is as long as the distance from the solids, but at least kSolidStep, so it misses a
/// solid only where less than that of the segment is inside.
bool BodySurface::crossesSolid(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  if (solids_.shapes.empty()) return false;
  const Eigen::Vector3d way = to - from;
  const double length = way.norm();
  double done = 0;
  for (int i = 0; i < kMaxSolidSteps && done < length; ++i) {
    const auto found = solidDistance(solids_, from + done / length * way);
    if (!found) return false;
    if (found->upper <= kSolidAccuracy) return true;
    done += std::max(found->lower, kSolidStep);
  }
  return false;
}

std::optional<bool> BodySurface::contains(const Eigen::Vector3d& point) const {
  std::optional<bool> result = false;
  for (const Mesh& mesh : meshes_) {
    const std::optional<bool> is_inside = mesh.inside.contains(point);
    if (is_inside == true) return true;
    if (!is_inside) result = std::nullopt;
  }
  return result;
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

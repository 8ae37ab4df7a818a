// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray first hits a body: what a depth camera or a laser would measure.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/distance/triangle_tree.h"

namespace link_bounds {

/// Triangles in a binary tree of axis-aligned boxes, which shares no code with TriangleTree.
class RayTriangles {
 public:
  explicit RayTriangles(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    if (!triangles_.empty()) build(0, triangles_.size());
  }

  /// Along the ray in units of `direction`; infinite without a hit.
  double hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
    double best = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) visit(0, from, direction, best);
    return best;
  }

 private:
  struct Node {
    Aabb box;
    std::size_t begin, end, right;  ///< the left child follows; right is 0 in a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({Aabb(), begin, end, 0});
    for (std::size_t i = begin; i < end; ++i) {
      for (const Eigen::Vector3d& corner : triangles_[i])
        nodes_[index].box.extend(corner);
    }
    if (end - begin <= 4) return index;
    int axis = 0;
    nodes_[index].box.sizes().maxCoeff(&axis);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) {
      return triangles_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Triangle& a, const Triangle& b) {
      return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
    });
    build(begin, middle);
    const std::size_t right = build(middle, end);
    nodes_[index].right = right;
    return index;
  }

  static bool meets(const Aabb& box, const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                    double best) {
    double begin = 0, end = best;
    for (int k = 0; k < 3; ++k) {
      const double a = (box.min()[k] - from[k]) / direction[k];
      const double b = (box.max()[k] - from[k]) / direction[k];
      if (direction[k] == 0) {
        if (from[k] < box.min()[k] || from[k] > box.max()[k]) return false;
        continue;
      }
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    return begin <= end * (1 + 1e-12) + 1e-12;
  }

  void visit(std::size_t index, const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
             double& best) const {
    const Node& node = nodes_[index];
    if (!meets(node.box, from, direction, best)) return;
    if (node.right != 0) {
      visit(index + 1, from, direction, best);
      visit(node.right, from, direction, best);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      best = std::min(best, hit(triangles_[i], from, direction));
  }

  /// As Moeller and Trumbore (1997) do it.
  static double hit(const Triangle& triangle, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& direction) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const Eigen::Vector3d u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
    const Eigen::Vector3d p = direction.cross(v);
    const double determinant = u.dot(p);
    if (determinant == 0) return kNone;
    const Eigen::Vector3d way = from - triangle[0];
    const double a = way.dot(p) / determinant;
    const Eigen::Vector3d q = way.cross(u);
    const double b = direction.dot(q) / determinant;
    const double t = v.dot(q) / determinant;
    return a >= 0 && b >= 0 && a + b <= 1 && t > 0 ? t : kNone;
  }

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// The surface of a body in its own frame.
class RayCaster {
 public:
  explicit RayCaster(const Body& body) : triangles_(trianglesOf(body)) {
    for (const BodyShape& shape : body.shapes) {
      if (shape.triangles) continue;
      solids_.push_back(shape.shape);
      inverses_.push_back(shape.shape.link_from_shape.inverse());
    }
  }

  /// As above. From inside a solid, it is where the ray leaves it.
  double hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
    double best = triangles_.hit(from, direction);
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      const Eigen::Vector3d half = solids_[i].size / 2;
      const Eigen::Vector3d start = (inverses_[i] * from).cwiseQuotient(half);
      const Eigen::Vector3d way = (inverses_[i].linear() * direction).cwiseQuotient(half);
      best = std::min(best, hitUnit(solids_[i].solid, start, way));
    }
    return best;
  }

 private:
  struct Part {
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
    void cut(double a, double b) {
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
  };

  static std::vector<Triangle> trianglesOf(const Body& body) {
    std::vector<Triangle> result;
    for (const BodyShape& shape : body.shapes) {
      for (std::size_t i = 0; shape.triangles && i < shape.triangles->triangles.size(); ++i) {
        result.push_back(shape.triangles->corners(i));
        for (Eigen::Vector3d& corner : result.back())
          corner = shape.shape.link_from_shape * corner;
      }
    }
    return result;
  }

  /// A solid of half size 1.
  static double hitUnit(Solid solid, const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
    Part part;
    const int slabs = solid == Solid::kBox ? 0 : solid == Solid::kCylinder ? 2 : 3;
    for (int k = slabs; k < 3; ++k)
      part.cut((-1 - from[k]) / way[k], (1 - from[k]) / way[k]);
    const int round = slabs;  // the number of axes of the disc or the ball
    const double a = way.head(round).squaredNorm(), b = way.head(round).dot(from.head(round));
    const double c = from.head(round).squaredNorm() - 1;
    if (round > 0 && a > 0) {
      const double root = b * b - a * c;
      if (!(root >= 0)) return std::numeric_limits<double>::infinity();
      part.cut((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
    }
    if (!(part.begin <= part.end && part.end > 0)) return std::numeric_limits<double>::infinity();
    return part.begin > 0 ? part.begin : part.end;
  }

  RayTriangles triangles_;
  std::vector<Shape> solids_;
  std::vector<Eigen::Affine3d> inverses_;
};

}  // namespace link_bounds

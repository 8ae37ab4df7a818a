// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Convex sets as GJK sees them: each tells its farthest point along a direction, in the coordinates
// of its shape.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// Shorter vectors have no direction, because their squares underflow.
constexpr double kShortest = 1e-140;

/// Where a shape is during a search: in the axes of the world, from an origin near both bodies, so
/// that no digits are lost far from the origin of the world.
struct Placement {
  Eigen::Matrix3d linear;
  Eigen::Vector3d translation;

  Eigen::Vector3d toSearch(const Eigen::Vector3d& point) const {
    return linear * point + translation;
  }
  /// The direction d' with d' . p = d . (linear p).
  Eigen::Vector3d toShape(const Eigen::Vector3d& direction) const {
    return linear.transpose() * direction;
  }
};

/// The farthest point of a solid along a direction; zero for Solid::kNone.
Eigen::Vector3d farthestOf(Solid solid, const Eigen::Vector3d& size,
                           const Eigen::Vector3d& direction);

/// The convex hull of a shape.
struct ShapeHull {
  const BodyShape& body_shape;
  bool is_core = false;  ///< the hull of the points alone, without the solid that sweeps them

  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    const Shape& shape = body_shape.shape;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    if (shape.solid != Solid::kNone && !is_core)
      point = farthestOf(shape.solid, shape.size, direction);
    if (shape.points) point += shape.points->farthest(direction);
    const std::optional<Eigen::Vector3d>& tip = body_shape.tip;
    return tip && tip->dot(direction) > point.dot(direction) ? *tip : point;
  }
};

/// A parallelepiped: all center + sum of a_k edges[k] with |a_k| <= 1.
struct Parallelepiped {
  Eigen::Vector3d center;
  std::array<Eigen::Vector3d, 3> edges;

  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    Eigen::Vector3d point = center;
    for (const Eigen::Vector3d& edge : edges)
      point += std::copysign(1.0, edge.dot(direction)) * edge;
    return point;
  }
};

/// A triangle that a solid sweeps.
struct SweptTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Solid solid;
  Eigen::Vector3d size;

  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    const double a = corners[0].dot(direction);
    const double b = corners[1].dot(direction);
    const double c = corners[2].dot(direction);
    const std::size_t best = a >= b ? (a >= c ? 0 : 2) : (b >= c ? 1 : 2);
    if (solid == Solid::kNone) return corners[best];
    return corners[best] + farthestOf(solid, size, direction);
  }
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A body at its pose, with the data that every search needs and a bound of its rounding.
#pragma once

#include <optional>

#include "geometry/distance/convex_sets.h"
#include "geometry/distance/lease.h"
#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// Points nearer to the centre than `inside` belong to the ball; points farther than `outside` do
/// not [m].
struct PlacedBall {
  double inside = 0;
  double outside = 0;
};

struct PlacedShape {
  const BodyShape* shape;
  Placement from_body_origin;  ///< in the axes of the world, from the origin of the body
  Aabb box;                    ///< in the world
  PlacedBall ball;             ///< of a shape that hasCore()
};

struct PlacedBody {
  Eigen::Vector3d origin;  ///< in the world
  std::vector<PlacedShape> shapes;
  Aabb box;                   ///< of all shapes, in the world
  Eigen::Vector3d any_point;  ///< of the body, from its origin, in the axes of the world
  /// Bounds the error of a computed support of any shape along a unit direction, beyond that of
  /// the position of the origin [m].
  double rounding;
  std::optional<RigidBody> rigid;  ///< if its motion is followed, and its pose is rigid
};

/// `body` must outlive the result. Nothing if there is no shape or one has no finite box.
std::optional<PlacedBody> placedBody(const Body& body, const Eigen::Affine3d& world_from_body);

/// Bounds the error of a computed distance along a unit direction [m]: that of both bodies and of
/// the offset of their origins.
double pairRounding(const PlacedBody& first, const PlacedBody& second);

}  // namespace link_bounds

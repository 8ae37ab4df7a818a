// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// A shape and its exact box under any affine pose.
///
/// Every shape is a Minkowski sum: a set of points (absent: the origin alone) swept by a solid.
/// A mesh is points swept by nothing, a sphere is the origin swept by a ball, a bunch of cubes is
/// points swept by a box. The box of a sum is the sum of the boxes, so one function serves all.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <optional>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/support/point_set.h"

namespace link_bounds {

/// The solid that sweeps the points, centred on each; its axes are those of the shape.
enum class Solid { kNone, kBox, kEllipsoid, kCylinder };

struct Shape {
  std::shared_ptr<const PointSet> points;  ///< null: the origin alone
  Solid solid = Solid::kNone;
  /// Full extents of the solid along its axes [m]; of a cylinder two diameters and the length
  /// along z. Applies to the solid only, not to the points.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  /// Origin and mesh scale; may mirror, flatten or shear.
  Eigen::Affine3d link_from_shape = Eigen::Affine3d::Identity();
};

/// True if every entry is finite and none of the linear part exceeds 1e30, so that no product
/// with a float32 vertex overflows.
bool isUsablePose(const Eigen::Affine3d& pose);

/// How far a shape reaches from its own origin along the axes of the world, and for which linear
/// part of its pose. Kept from one update to the next, it spares all work but the translation for
/// axes whose row has not changed: the paper's rule for objects that only move. It belongs to one
/// shape; a fresh one knows nothing.
struct ShapeReach {
  explicit ShapeReach(const Shape& shape);

  Eigen::Matrix3d linear = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Extents range;          ///< metres, before translation; rounded outward
  double pad_per_entry;   ///< what rounding may cost, for an entry of 1 in the linear part [m]
  bool is_in_link_frame;  ///< link_from_shape is the identity
};

/// The box of the shape in the world, tight and rounded outward: each face lies outside the exact
/// one by at most 4e-14 A |r|_1 + 2e-15 |t| (and 1e-307 m against underflow), where r is the row of
/// the linear part, t the translation along that axis and A the largest |coordinate| of the points
/// plus half the size. Nothing if the pose is not usable or a face would not be finite. `reach`
/// changes speed and nothing else.
std::optional<Aabb> placedBox(const Shape& shape, const Eigen::Affine3d& world_from_shape,
                              ShapeReach& reach);

/// The same for a shape on a link.
std::optional<Aabb> worldBox(const Shape& shape, const Eigen::Affine3d& world_from_link);

}  // namespace link_bounds

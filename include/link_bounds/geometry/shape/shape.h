// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// A shape and its exact box under any affine pose.
///
/// Every shape is a Minkowski sum: a set of points (absent: the origin alone) swept by a solid.
/// A mesh is points swept by nothing, a sphere is the origin swept by a ball, a bunch of cubes is
/// points swept by a box. The box of a sum is the sum of the boxes, so one function serves all.
#pragma once

#include <Eigen/Geometry>
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

/// The box of a shape on a link, tight and rounded outward: each face lies outside the exact one
/// by at most 4e-14 A |r|_1 + 2e-15 |t| (and 1e-307 m against underflow), where r is the row of the
/// linear part of world_from_shape, t its translation along that axis and A the largest
/// |coordinate| of the points plus half the size. Nothing if world_from_shape is not usable (see
/// isUsablePose) or a face would not be finite.
std::optional<Aabb> worldBox(const Shape& shape, const Eigen::Affine3d& world_from_link);

}  // namespace link_bounds

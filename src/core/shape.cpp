// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extents of points plus half-extents of the solid, moved by the translation and padded outward.
#include "link_bounds/shape.h"

#include <cmath>
#include <limits>

#include "link_bounds/rounding.h"

namespace link_bounds {
namespace {

constexpr double kLargestLinearEntry = 1e30;

/// Tolerance with which vertices may be left out of an accelerated point set, relative to the
/// largest |coordinate|, and as much again for evaluating it.
constexpr double kPointTolerance = 2e-14;

/// Eight roundings bound every evaluation below: five of a dot product, one each for adding the
/// solid, the translation and the pad.
constexpr double kRoundingPad = 8 * kUnitRoundoff;

/// Products of tiny numbers lose digits below the smallest normal number.
constexpr double kUnderflowPad = std::numeric_limits<double>::min();

/// Half the extent of the solid along one axis of the world; `row` is that axis' row of the
/// linear part times diag(size). The support functions of the unit box, ball and cylinder.
double halfExtent(Solid solid, const Eigen::Vector3d& row) {
  switch (solid) {
    case Solid::kNone:
      return 0;
    case Solid::kBox:
      return row.lpNorm<1>() / 2;
    case Solid::kEllipsoid:
      return row.stableNorm() / 2;
    case Solid::kCylinder:
      return (std::hypot(row.x(), row.y()) + std::abs(row.z())) / 2;
  }
  return 0;
}

}  // namespace

bool isUsablePose(const Eigen::Affine3d& pose) {
  return pose.translation().allFinite() &&
         (pose.linear().array().abs() <= kLargestLinearEntry).all();
}

std::optional<Aabb> worldBox(const Shape& shape, const Eigen::Affine3d& world_from_link) {
  const Eigen::Affine3d world_from_shape = world_from_link * shape.link_from_shape;
  if (!isUsablePose(world_from_shape)) return std::nullopt;
  const Eigen::Matrix3d& linear = world_from_shape.linear();
  const Eigen::Vector3d translation = world_from_shape.translation();

  Extents extents{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  Eigen::Vector3d reach = shape.size / 2;
  double tolerance = 0;
  if (shape.points) {
    extents = shape.points->extents(linear);
    reach += shape.points->magnitude();
    tolerance = kPointTolerance * shape.points->magnitude().maxCoeff();
  }

  Aabb box;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d row = linear.row(k);
    const double half = halfExtent(shape.solid, row.cwiseProduct(shape.size));
    const double pad = kRoundingPad * (row.cwiseAbs().dot(reach) + std::abs(translation[k])) +
                       tolerance * row.lpNorm<1>() + kUnderflowPad;
    box.min()[k] = (translation[k] + (extents.low[k] - half)) - pad;
    box.max()[k] = (translation[k] + (extents.high[k] + half)) + pad;
  }
  if (!box.min().allFinite() || !box.max().allFinite()) return std::nullopt;
  return box;
}

}  // namespace link_bounds

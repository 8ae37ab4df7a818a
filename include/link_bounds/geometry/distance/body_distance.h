// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The distance of two bodies between two proven bounds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// The level that decided the lower bound: axis-aligned boxes, convex hulls, or triangles.
enum class DistanceLevel { kBox, kHull, kMesh };

/// Lengths are metres, points and directions are in the world.
struct BodyDistance {
  /// Proven: no point of one body is nearer to the other. 0: they may touch.
  double lower;
  /// Proven upper bound: the distance of on_first and on_second before these are rounded.
  double upper;
  Eigen::Vector3d on_first;  ///< a point of the first body
  Eigen::Vector3d on_second;
  /// Unit, from the first body to the second; zero if `lower` is 0. At the levels kBox and kHull,
  /// bodies of one shape each are at least `lower` apart along it, which proves `lower`; for bodies
  /// of several shapes, this may hold for two shapes only. At kMesh it is the direction from
  /// on_first to on_second, and no single direction proves `lower`.
  Eigen::Vector3d normal;
  DistanceLevel level;
};

struct DistanceGoal {
  /// `upper` - `lower` shall not exceed this [m], > 0. Rounding is added: up to 1e-12 of the
  /// largest coordinates of both bodies and of the distance of their origins. Even close to
  /// contact, 1e-8 of the bodies' size is reached.
  double accuracy = 1e-4;
  /// Bodies that are proven to be farther apart need no accuracy [m], >= 0.
  double limit = std::numeric_limits<double>::infinity();
  /// Max number of pairs of tree nodes that are compared. Where they do not suffice, both bounds
  /// hold, but differ by more than `accuracy`.
  std::size_t max_steps = 1'000'000;
  /// From 0 to less than 1: `upper` - `lower` may also be that part of `upper`, if it is more than
  /// `accuracy`.
  double relative_accuracy = 0;

  /// Max difference of the bounds if the upper one is `upper` [m].
  double tolerance(double upper) const { return std::max(accuracy, relative_accuracy * upper); }

  /// The min lower bound that suffices if the upper one is `upper` [m].
  double enough(double upper) const {
    return std::min({limit, upper - accuracy, (1 - relative_accuracy) * upper});
  }
};

/// `lower` and `upper` differ by at most goal.tolerance(upper) and rounding if each shape has
/// triangles or is a solid with at most one point, and neither goal.limit nor goal.max_steps ended
/// the search. Nothing if a body has no shape, or a pose gives no box within 1e60 m. The other
/// order of the bodies gives the same bounds, with the points swapped and the normal reversed; two
/// bodies in the same place may get other points that are as near.
/// Poses may be any affine transform. Throws nothing but std::bad_alloc.
std::optional<BodyDistance> bodyDistance(const Body& first, const Eigen::Affine3d& world_from_first,
                                         const Body& second,
                                         const Eigen::Affine3d& world_from_second,
                                         const DistanceGoal& goal = {});

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace link_bounds {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// A point of each of two sets.
struct PointPair {
  Eigen::Vector3d on_first;
  Eigen::Vector3d on_second;
  double squared;  ///< their distance, squared
};

/// The nearest points of two triangles; if these intersect, a common point. The triangles may be
/// segments or points. Each point is a convex combination of corners whatever rounding does, so
/// `squared` is never too small. May return earlier found points if the triangles are at least
/// `enough` apart along the line through them.
PointPair nearestPoints(const Triangle& first, const Triangle& second,
                        double enough = std::numeric_limits<double>::infinity());

/// The gap from `first` to `second` along `normal`, times the length of `normal`; negative if they
/// overlap along it.
double gapAlong(const Eigen::Vector3d& normal, const Triangle& first, const Triangle& second);

}  // namespace link_bounds

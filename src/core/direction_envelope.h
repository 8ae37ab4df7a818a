// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points reach farthest for at least one direction of a cone.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace link_bounds {

/// A convex cone, by the directions of its edges in order around it.
using Cone = std::vector<Eigen::Vector3d>;

using PointIndices = std::vector<std::uint32_t>;

/// Finds the upper envelope of linear functionals d -> p . d over a cone of directions d.
///
/// A point p is needed where it beats all the others, so the cone is clipped by the half-spaces
/// (p - q) . d > tolerance of the points q that are already known to be needed. If nothing is left,
/// p is not needed. If something is, whichever point reaches farthest in the middle of the rest is,
/// and p is tried again (the idea of Clarkson's redundancy removal). So a point is left out only
/// for points that stay: tolerances do not add up.
class Envelope {
 public:
  /// `points` must outlive this.
  Envelope(const std::vector<Eigen::Vector3d>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {}

  /// Appends to `needed` those of the candidates that are needed within the cone for the largest
  /// sign * (p . d); |sign| = 1.
  void appendNeeded(const PointIndices& candidates, const Cone& cone, double sign,
                    PointIndices& needed);

 private:
  std::uint32_t farthest(const PointIndices& candidates, const Eigen::Vector3d& direction) const;
  bool clip(const Eigen::Vector3d& normal);
  bool clipByKept(std::uint32_t point, double sign);
  void decide(std::uint32_t point, const PointIndices& candidates, const Cone& cone, double sign);
  bool keep(std::uint32_t point);

  const std::vector<Eigen::Vector3d>& points_;
  double tolerance_;
  PointIndices kept_;
  Cone region_;
  Cone clipped_;
  std::vector<double> heights_;
};

}  // namespace link_bounds

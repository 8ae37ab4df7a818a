// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points are extreme for at least one direction of a cone.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/support/table/direction_dominance.h"
#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

/// kMinimal leaves out every point that is not needed. kQuick takes time in proportion to the
/// number of candidates, and leaves out only points that a few others beat together.
enum class Effort { kQuick, kMinimal };

/// Finds the upper envelope of linear functionals d -> p . d over a cone of directions d.
///
/// A point p is needed where it beats all the others, so the cone is clipped to the half-spaces
/// where (p - q) . d > tolerance of all points q that are already known to be needed. If nothing is
/// left, p is not needed. If something is, the point that is extreme in the middle of the rest is
/// needed, and p is tried again (the idea of Clarkson's redundancy removal). So a point is left out
/// only because of points that stay, and tolerances do not add up.
class Envelope {
 public:
  /// `points` and `meter` must outlive this.
  Envelope(const std::vector<Eigen::Vector3d>& points, double tolerance, Effort effort,
           WorkMeter& meter)
      : points_(points), tolerance_(tolerance), effort_(effort), meter_(meter) {}

  /// Those of the candidates, in ascending order, that are needed within one of the cones for the
  /// largest sign * (p . d); |sign| = 1. With kQuick, it may return more candidates.
  PointIndices neededOf(const PointIndices& candidates, const std::vector<Cone>& cones,
                        double sign);

 private:
  void begin(const PointIndices& candidates, const Cone& cone);
  void searchQuickly(const PointIndices& candidates, const Cone& cone);
  void search(const PointIndices& candidates, const Cone& cone, int depth);
  void searchHalves(const PointIndices& candidates, const Cone& cone, int depth);
  void searchAll(const PointIndices& candidates, const Cone& cone);
  void keepChampions(const PointIndices& candidates, const Cone& cone);
  PointIndices beyondChampions(const PointIndices& candidates, const Cone& cone);
  void decide(std::uint32_t point, const PointIndices& candidates, const Cone& cone);
  std::uint32_t farthest(const PointIndices& candidates, const Eigen::Vector3d& direction) const;
  bool clip(std::uint32_t point, std::uint32_t other);
  bool clipByKept(std::uint32_t point);
  bool keep(std::uint32_t point);

  const std::vector<Eigen::Vector3d>& points_;
  double tolerance_;
  Effort effort_;
  WorkMeter& meter_;
  double sign_ = 1;
  std::size_t looks_ = 0;        ///< budget for halving cones, see kLooks
  std::vector<bool> is_needed_;  ///< by point: needed in any cone so far
  PointIndices needed_;
  PointIndices kept_;  ///< needed in the current cone
  Cone region_;
  Cone clipped_;
  std::vector<double> heights_;
};

}  // namespace link_bounds

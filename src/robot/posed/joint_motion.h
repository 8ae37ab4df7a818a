// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The motion of all joints between two way points, as joint_trajectory_controller interpolates.
#pragma once

#include <array>
#include <vector>

#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// One value per joint of a robot with simple joints; those of mimic joints are ignored.
struct WayPoint {
  std::vector<double> positions;      ///< rad or m
  std::vector<double> velocities;     ///< per s; may be empty
  std::vector<double> accelerations;  ///< per s²; may be empty
  double time = 0;                    ///< s; used only with velocities
};

/// Polynomials in the share of the time between the two way points, from 0 to 1.
class JointMotion {
 public:
  /// Linear; cubic where both have velocities; of fifth order where both have accelerations, too.
  /// `to.time` is then larger than `from.time`.
  JointMotion(const WayPoint& from, const WayPoint& to);

  /// The values of all joints [rad or m].
  std::vector<double> at(double share) const;

  /// Upper bound of how much a value of the joint between `share` - `half` and `share` + `half`
  /// differs from that at `share` [rad or m].
  double spread(std::size_t joint, double share, double half) const;

  /// By joint: a range that holds all its values on the way, and those of `others`, if any.
  std::vector<Limits> ranges(const std::vector<Limits>& others = {}) const;

  /// False where the numbers are so large that a range is not finite. Such a motion must be
  /// refused.
  bool isFinite() const;

 private:
  static constexpr int kOrders = 6;
  using Polynomial = std::array<double, kOrders>;

  std::vector<Polynomial> joints_;
};

}  // namespace link_bounds

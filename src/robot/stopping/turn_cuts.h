// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// At which angles turns are examined, so that a few looks at the link give a tight box.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "robot/stopping/moving_link.h"

namespace link_bounds {

/// A ball that holds all places of a link while joints move.
struct SweptBall {
  Eigen::Vector3d center;
  double radius;  ///< [m]
};

/// One joint, with what is common to all directions.
struct MovingStep {
  const MovingJoint* joint;
  Limits offsets;                           ///< within one turn
  std::vector<Eigen::Matrix3d> turns = {};  ///< rotations by the examined angles
  double half_piece = 0;  ///< half the angle between two; of one: to each end [rad]
};

/// Max motion of a point at a distance of 1 m from the axis during a turn by `angle` [m].
inline double chordOf(double angle) {
  return 2 * std::sin(std::min(std::abs(angle), M_PI) / 2);
}

/// Sets how the turns are examined. `balls` are around all places of the link while the joints from
/// each one on move, and last around the link.
void chooseCuts(std::vector<MovingStep>& steps, const std::vector<SweptBall>& balls);

}  // namespace link_bounds

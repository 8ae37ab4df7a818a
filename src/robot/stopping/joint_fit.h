// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The value of a joint from the pose of its link.
#pragma once

#include <Eigen/Geometry>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The joint value nearest to a pose, whatever the limits, and how far the pose is from that of
/// such a joint.
struct JointFit {
  double value = 0;  ///< [rad, from -pi to pi, or m]; of a planar joint its turn, of a fixed one 0
  double length_error = 0;  ///< [m]
  double angle_error = 0;   ///< [rad]
};

/// For any joint but a floating one; a joint without an axis counts as fixed.
JointFit fitOf(const Joint& joint, const Eigen::Isometry3d& parent_from_child);

/// The angle without full turns, from -pi to pi [rad].
double withoutTurns(double angle);

}  // namespace link_bounds

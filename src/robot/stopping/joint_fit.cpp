// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The rotation by 2 atan2(v . axis, w) about the axis is the nearest one to the quaternion (v, w).
#include "robot/stopping/joint_fit.h"

#include <cmath>

namespace link_bounds {
namespace {

double angleOf(const Eigen::Quaterniond& rotation) {
  return 2 * std::atan2(rotation.vec().norm(), std::abs(rotation.w()));
}

}  // namespace

double withoutTurns(double angle) {
  return std::remainder(angle, 2 * M_PI);
}

JointFit fitOf(const Joint& joint, const Eigen::Isometry3d& parent_from_child) {
  const Eigen::Isometry3d moved = joint.parent_from_joint.inverse() * parent_from_child;
  const Eigen::Quaterniond rotation(moved.linear());
  const bool has_axis = !joint.axis.isZero(0);
  JointFit fit;
  const bool is_planar = joint.motion == Motion::kPlanar;
  if (has_axis && (joint.motion == Motion::kRotation || is_planar)) {
    fit.value = withoutTurns(2 * std::atan2(rotation.vec().dot(joint.axis), rotation.w()));
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(fit.value, joint.axis));
    fit.angle_error = angleOf(turn.conjugate() * rotation);
    fit.length_error =
        is_planar ? std::abs(moved.translation().dot(joint.axis)) : moved.translation().norm();
  } else if (has_axis && joint.motion == Motion::kTranslation) {
    fit.value = moved.translation().dot(joint.axis);
    fit.angle_error = angleOf(rotation);
    fit.length_error = (moved.translation() - fit.value * joint.axis).norm();
  } else {
    fit.angle_error = angleOf(rotation);
    fit.length_error = moved.translation().norm();
  }
  return fit;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of links in quadruple precision, from their definition in URDF.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "testing/quad.h"

namespace link_bounds {

using QuadMatrix = Eigen::Matrix<Quad, 3, 3>;
using QuadColumn = Eigen::Matrix<Quad, 3, 1>;

struct QuadPose {
  QuadMatrix linear = QuadMatrix::Identity();
  QuadColumn translation = QuadColumn::Zero();

  QuadPose operator*(const QuadPose& other) const {
    return {linear * other.linear, linear * other.translation + translation};
  }
  QuadColumn operator*(const QuadColumn& point) const { return linear * point + translation; }
  /// Of a rotation.
  QuadPose inverse() const { return {linear.transpose(), -(linear.transpose() * translation)}; }
};

inline QuadPose toQuad(const Eigen::Isometry3d& pose) {
  return {pose.linear().cast<Quad>(), pose.translation().cast<Quad>()};
}

/// Sine and cosine by their series; for angles of a few turns at most.
inline std::array<Quad, 2> quadSineCosine(Quad angle) {
  std::array<Quad, 2> result{0, 0};
  Quad term = 1;
  for (int n = 0; n < 120; ++n) {
    result[n % 2 == 0 ? 1 : 0] += n % 4 < 2 ? term : -term;
    term *= angle / (n + 1);
  }
  return result;
}

inline QuadPose quadMotion(const Joint& joint, double value) {
  QuadPose pose;
  const QuadColumn axis = joint.axis.cast<Quad>();
  if (joint.motion == Motion::kTranslation) pose.translation = axis * Quad(value);
  if (joint.motion != Motion::kRotation) return pose;
  const auto [sine, cosine] = quadSineCosine(value);
  QuadMatrix cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  const Quad length2 = axis.dot(axis);  // 1, but for the rounding of the axis
  pose.linear = QuadMatrix::Identity() + cross * sine + cross * cross * ((1 - cosine) / length2);
  return pose;
}

/// In the frame of the root link; one value per joint of a robot with simple joints.
inline std::vector<QuadPose> quadLinkPoses(const Robot& robot, const std::vector<double>& values) {
  std::vector<QuadPose> poses(robot.links.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    poses[joint.child] =
        poses[joint.parent] * toQuad(joint.parent_from_joint) * quadMotion(joint, values[i]);
  }
  return poses;
}

}  // namespace link_bounds

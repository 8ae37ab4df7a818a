// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Forward kinematics, from the root outward.
#include "link_bounds/robot/urdf/kinematics.h"

#include <cmath>

namespace link_bounds {
namespace {

using JointIndex = std::map<std::string, std::size_t>;

/// The joint that `joint` mimics; throws if there is none.
std::size_t leaderOf(const Joint& joint, const JointIndex& index) {
  const auto leader = index.find(joint.mimic->joint);
  if (leader != index.end()) return leader->second;
  throw JointError("joint \"" + joint.name + "\" mimics \"" + joint.mimic->joint +
                   "\", which is no joint of the robot");
}

/// Follows a chain of mimic joints to the joint q that leads it: value = factor * q + offset.
double mimickedValue(const Robot& robot, const JointIndex& index, std::size_t joint,
                     const std::vector<double>& values) {
  double factor = 1;
  double offset = 0;
  std::size_t current = joint;
  for (std::size_t steps = 0; robot.joints[current].mimic; ++steps) {
    if (steps > robot.joints.size()) {
      throw JointError("joint \"" + robot.joints[joint].name + "\" mimics in a circle");
    }
    const Mimic& mimic = *robot.joints[current].mimic;
    offset += factor * mimic.offset;
    factor *= mimic.multiplier;
    current = leaderOf(robot.joints[current], index);
  }
  return factor * values[current] + offset;
}

Eigen::Isometry3d jointMotion(const Joint& joint, double value) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (joint.motion == Motion::kNone || value == 0) return result;
  if (joint.axis.isZero(0)) {
    throw JointError("joint \"" + joint.name + "\" cannot move, its axis is zero");
  }
  if (joint.motion == Motion::kRotation) {
    result.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  } else {
    result.translation() = value * joint.axis;
  }
  return result;
}

}  // namespace

std::vector<double> jointValues(const Robot& robot, const std::map<std::string, double>& given) {
  JointIndex index;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    index.emplace(robot.joints[i].name, i);
  std::vector<double> values(robot.joints.size(), 0.0);
  for (const auto& [name, value] : given) {
    const auto joint = index.find(name);
    if (joint == index.end() || robot.joints[joint->second].motion == Motion::kNone) {
      throw JointError("\"" + name + "\" is no movable joint of the robot");
    }
    if (!std::isfinite(value))
      throw JointError("the value of joint \"" + name + "\" is not finite");
    values[joint->second] = value;
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].mimic) values[i] = mimickedValue(robot, index, i, values);
  }
  return values;
}

std::vector<Eigen::Isometry3d> linkPoses(const Robot& robot, const std::vector<double>& values) {
  std::vector<Eigen::Isometry3d> root_from_link(robot.links.size(), Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    root_from_link[joint.child] =
        root_from_link[joint.parent] * joint.parent_from_joint * jointMotion(joint, values[i]);
  }
  return root_from_link;
}

}  // namespace link_bounds

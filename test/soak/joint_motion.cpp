// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ignores limits and mimic joints: the soak test needs motion, not valid poses.
#include "joint_motion.h"

#include <cmath>

namespace link_bounds {
namespace {

constexpr double kAmplitude = 0.3;    // rad or m
constexpr double kAngularSpeed = 2;   // rad/s of the swing
constexpr double kPhasePerJoint = 1;  // rad

Eigen::Isometry3d motionOf(const Joint& joint, double value) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (joint.motion == Motion::kRotation) motion.rotate(Eigen::AngleAxisd(value, joint.axis));
  if (joint.motion == Motion::kTranslation) motion.translate(value * joint.axis);
  return motion;
}

geometry_msgs::TransformStamped transformOf(const Robot& robot, const Joint& joint, double value,
                                            ros::Time stamp) {
  const Eigen::Isometry3d parent_from_child = joint.parent_from_joint * motionOf(joint, value);
  const Eigen::Quaterniond q(parent_from_child.linear());
  geometry_msgs::TransformStamped result;
  result.header.frame_id = robot.links[joint.parent].name;
  result.header.stamp = stamp;
  result.child_frame_id = robot.links[joint.child].name;
  result.transform.translation.x = parent_from_child.translation().x();
  result.transform.translation.y = parent_from_child.translation().y();
  result.transform.translation.z = parent_from_child.translation().z();
  result.transform.rotation.x = q.x();
  result.transform.rotation.y = q.y();
  result.transform.rotation.z = q.z();
  result.transform.rotation.w = q.w();
  return result;
}

}  // namespace

tf2_msgs::TFMessage fixedTransforms(const Robot& robot) {
  tf2_msgs::TFMessage message;
  for (const Joint& joint : robot.joints) {
    if (hasValue(joint.motion)) continue;
    message.transforms.push_back(transformOf(robot, joint, 0, ros::Time(0)));
  }
  return message;
}

tf2_msgs::TFMessage movingTransforms(const Robot& robot, ros::Time time) {
  tf2_msgs::TFMessage message;
  double phase = 0;
  for (const Joint& joint : robot.joints) {
    if (!hasValue(joint.motion)) continue;
    phase += kPhasePerJoint;
    const double value = kAmplitude * std::sin(kAngularSpeed * time.toSec() + phase);
    message.transforms.push_back(transformOf(robot, joint, value, time));
  }
  return message;
}

}  // namespace link_bounds

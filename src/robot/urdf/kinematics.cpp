// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Forward kinematics, from the root outward.
#include "link_bounds/robot/urdf/kinematics.h"

#include <cmath>

#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

Eigen::Isometry3d jointMotion(Motion motion, const Eigen::Vector3d& axis, double value) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (motion == Motion::kRotation) {
    result.linear() = Eigen::AngleAxisd(value, axis).toRotationMatrix();
  } else if (motion == Motion::kTranslation) {
    result.translation() = value * axis;
  }
  return result;
}

Eigen::Isometry3d jointMotion(const Joint& joint, double value) {
  if (!hasValue(joint.motion) || value == 0) return Eigen::Isometry3d::Identity();
  if (joint.axis.isZero(0)) {
    throw JointError("joint \"" + joint.name +
                     "\" cannot move, its axis is zero; correct its <axis>");
  }
  return jointMotion(joint.motion, joint.axis, value);
}

std::vector<double> jointValues(const Robot& robot, const std::map<std::string, double>& given) {
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    index.emplace(robot.joints[i].name, i);
  std::vector<double> values(robot.joints.size(), 0.0);
  for (const auto& [name, value] : given) {
    const auto joint = index.find(name);
    if (joint == index.end() || !hasValue(robot.joints[joint->second].motion)) {
      throw JointError("\"" + name + "\" is no movable joint of the robot");
    }
    if (!std::isfinite(value))
      throw JointError("the value of joint \"" + name + "\" is not finite");
    values[joint->second] = value;
  }
  const std::vector<Lead> leads = leadsOf(robot);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].mimic)
      values[i] = leads[i].factor * values[leads[i].leader] + leads[i].offset;
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

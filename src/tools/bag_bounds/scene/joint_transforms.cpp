// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One transform per joint, by the kinematics of the URDF.
#include "tools/bag_bounds/scene/joint_transforms.h"

#include <algorithm>
#include <utility>

#include "link_bounds/robot/urdf/kinematics.h"
#include "world/model/model.h"

namespace link_bounds {

JointTransforms::JointTransforms(Robot robot, const std::string& tf_prefix)
    : robot_(std::move(robot)) {
  for (const Link& link : robot_.links)
    frames_.push_back(tfName(tf_prefix, link.name));
  const std::vector<Lead> leads = leadsOf(robot_);
  for (std::size_t i = 0; i < leads.size(); ++i) {
    const Joint& leader = robot_.joints[leads[i].leader];
    if (!hasValue(robot_.joints[i].motion) || !hasValue(leader.motion)) continue;
    followers_[leader.name].push_back({i, leads[i].factor, leads[i].offset});
    if (leads[i].leader != i) mimics_[robot_.joints[i].name] = i;
    is_met_[leader.name] = false;
  }
}

std::vector<TransformView> JointTransforms::fixed() const {
  std::vector<TransformView> result;
  for (const Joint& joint : robot_.joints) {
    if (joint.motion == Motion::kNone) result.push_back(transformOf(joint, 0, ros::Time()));
  }
  return result;
}

std::vector<TransformView> JointTransforms::of(const sensor_msgs::JointState& message,
                                               ros::Time stamp) {
  std::vector<TransformView> result;
  const std::size_t count = std::min(message.name.size(), message.position.size());
  std::map<std::string, double> told;
  for (std::size_t i = 0; i < count; ++i)
    told.emplace(message.name[i], message.position[i]);
  for (const auto& [name, value] : told) {
    const auto found = followers_.find(name);
    if (found != followers_.end()) {
      is_met_[name] = true;
      for (const Follower& follower : found->second) {
        const Joint& joint = robot_.joints[follower.joint];
        if (joint.name == name || told.count(joint.name) == 0)
          result.push_back(transformOf(joint, follower.factor * value + follower.offset, stamp));
      }
    }
    const auto mimic = mimics_.find(name);
    if (mimic != mimics_.end())
      result.push_back(transformOf(robot_.joints[mimic->second], value, stamp));
  }
  return result;
}

TransformView JointTransforms::transformOf(const Joint& joint, double value,
                                           ros::Time stamp) const {
  TransformView view(frames_[joint.parent], frames_[joint.child], "", stamp);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, value);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(pose.linear()).normalized();
  const Eigen::Vector3d place = pose.translation();
  view.parent_from_child = {tf2::Quaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                            tf2::Vector3(place.x(), place.y(), place.z())};
  return view;
}

std::vector<std::string> JointTransforms::missing() const {
  std::vector<std::string> names;
  for (const auto& [name, is_met] : is_met_) {
    if (!is_met) names.push_back(name);
  }
  return names;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names are as long as those of real robots, so they do not fit into a string object.
#include "bench/common/tf_robot.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace link_bounds::bench {
namespace {

constexpr double kAnglePerMessage = 0.002;  // rad

std::string frameName(std::size_t branch, std::size_t link) {
  return "branch_" + std::to_string(100 + branch) + "_joint_" + std::to_string(10 + link) + "_link";
}

/// Every joint turns about an axis of its own; by at most half the difference of two angles.
Eigen::Quaterniond turnOf(std::size_t joint, double angle) {
  const double phase = static_cast<double>(joint);
  const Eigen::Vector3d axis(std::sin(phase), std::cos(2 * phase), 0.5);
  return Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::sin(angle + phase), axis.normalized()));
}

tf2_msgs::TFMessage transformsOf(const TfRobot& robot, double angle) {
  tf2_msgs::TFMessage message;
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    const Eigen::Quaterniond turn = turnOf(i, angle);
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = robot.parents[i];
    transform.child_frame_id = robot.frames[i];
    transform.transform.translation.x = 0.1;
    transform.transform.translation.z = 0.2;
    transform.transform.rotation.x = turn.x();
    transform.transform.rotation.y = turn.y();
    transform.transform.rotation.z = turn.z();
    transform.transform.rotation.w = turn.w();
    message.transforms.push_back(transform);
  }
  return message;
}

}  // namespace

TfRobot tfRobot(std::size_t links, std::size_t depth) {
  TfRobot robot;
  robot.base = "the_base_of_the_robot";
  for (std::size_t i = 0; i < std::max(links, depth); ++i) {
    robot.parents.push_back(i % depth == 0 ? robot.base : robot.frames.back());
    robot.frames.push_back(frameName(i / depth, i % depth));
  }
  robot.links.assign(robot.frames.end() - static_cast<std::ptrdiff_t>(links), robot.frames.end());
  return robot;
}

std::vector<tf2_msgs::TFMessage> swing(const TfRobot& robot, std::size_t messages) {
  std::vector<tf2_msgs::TFMessage> result;
  for (std::size_t i = 0; i < messages; ++i) {
    const std::size_t steps = std::min(i, messages - i);
    result.push_back(transformsOf(robot, kAnglePerMessage * static_cast<double>(steps)));
  }
  return result;
}

}  // namespace link_bounds::bench

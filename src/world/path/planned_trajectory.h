// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A trajectory as it was sent, checked against a robot.
#pragma once

#include <trajectory_msgs/JointTrajectory.h>

#include <set>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/posed/joint_motion.h"

namespace link_bounds {

/// The joints that a trajectory sets, by name: those that mimic another joint do not count. Throws
/// std::runtime_error, with the remedy, for a name that is there twice, or is that of no movable
/// joint. `simple` has simple joints.
std::set<std::string> plannedJoints(const Robot& simple,
                                    const trajectory_msgs::JointTrajectory& trajectory);

class PlannedTrajectory {
 public:
  /// `simple` has simple joints, `joints` among them, which are those of plannedJoints(). Throws
  /// std::runtime_error, with the way point and the remedy, for what is no path.
  PlannedTrajectory(const Robot& simple, const std::set<std::string>& joints,
                    trajectory_msgs::JointTrajectory message);

  std::size_t segments() const { return message_.points.size() - 1; }

  /// From that way point to the next one.
  JointMotion motion(std::size_t segment) const;

  /// One per joint, which no motion leaves.
  std::vector<Limits> ranges() const;

  /// Those of plannedJoints(), by index, in the order of the message.
  const std::vector<std::size_t>& joints() const { return joints_; }

 private:
  using Point = trajectory_msgs::JointTrajectoryPoint;

  void check(std::size_t index) const;
  void checkNumbers(std::size_t index, const char* what, const std::vector<double>& numbers) const;
  WayPoint wayPoint(const Point& point) const;
  std::vector<double> spread(const std::vector<double>& numbers) const;

  std::size_t joint_count_;  ///< of the robot
  trajectory_msgs::JointTrajectory message_;
  std::vector<std::size_t> columns_;  ///< of joints_, in the message
  std::vector<std::size_t> joints_;
};

}  // namespace link_bounds

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

/// The names of the joints that a trajectory sets, without joints that mimic another one. Throws
/// std::runtime_error, with the remedy, for a repeated name and for a name of no movable joint.
/// `simple` is a robot with simple joints, see withSimpleJoints().
std::set<std::string> plannedJoints(const Robot& simple,
                                    const trajectory_msgs::JointTrajectory& trajectory);

class PlannedTrajectory {
 public:
  /// `simple` is a robot with simple joints; `joints` is the result of plannedJoints(). Throws
  /// std::runtime_error, with the way point and the remedy, if the message is no valid path.
  PlannedTrajectory(const Robot& simple, const std::set<std::string>& joints,
                    trajectory_msgs::JointTrajectory message);

  std::size_t segments() const { return message_.points.size() - 1; }

  /// The motion from way point `segment` to the next one.
  JointMotion motion(std::size_t segment) const;

  /// One range of values per joint of the robot, which no motion leaves.
  std::vector<Limits> ranges() const;

  /// The indices in the robot of plannedJoints(), in the order of the message.
  const std::vector<std::size_t>& joints() const { return joints_; }

 private:
  using Point = trajectory_msgs::JointTrajectoryPoint;

  void check(std::size_t index) const;
  void checkNumbers(std::size_t index, const char* what, const std::vector<double>& numbers) const;
  WayPoint wayPoint(const Point& point) const;
  std::vector<double> spread(const std::vector<double>& numbers) const;

  std::size_t joint_count_;  ///< number of joints of the robot
  trajectory_msgs::JointTrajectory message_;
  std::vector<std::size_t> columns_;  ///< for each of joints_ its index in the message
  std::vector<std::size_t> joints_;
};

}  // namespace link_bounds

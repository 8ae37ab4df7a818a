// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Keeps the way points in the message, and makes the motion between two of them only when asked.
#include "world/path/planned_trajectory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "robot/urdf/simple_joints.h"

namespace link_bounds {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw std::runtime_error(reason);
}

std::string pointName(std::size_t index) {
  return "points[" + std::to_string(index) + "]";
}

}  // namespace

std::set<std::string> plannedJoints(const Robot& simple,
                                    const trajectory_msgs::JointTrajectory& trajectory) {
  if (trajectory.joint_names.empty()) refuse("trajectory.joint_names is empty; name the joints");
  std::set<std::string> names;
  for (const std::string& name : trajectory.joint_names) {
    const std::string reason = whyNoJoint(simple, name);
    if (!reason.empty()) refuse("trajectory.joint_names: " + reason);
    if (!names.insert(name).second)
      refuse("trajectory.joint_names has \"" + name + "\" twice; remove one");
  }
  for (const std::string& name : trajectory.joint_names) {
    if (movableJoint(simple, name).mimic) names.erase(name);
  }
  if (names.empty())
    refuse("all of trajectory.joint_names follow other joints; name those that they follow");
  return names;
}

PlannedTrajectory::PlannedTrajectory(const Robot& simple, const std::set<std::string>& joints,
                                     trajectory_msgs::JointTrajectory message)
    : joint_count_(simple.joints.size()), message_(std::move(message)) {
  for (std::size_t i = 0; i < message_.joint_names.size(); ++i) {
    if (!joints.count(message_.joint_names[i])) continue;
    const Joint& joint = movableJoint(simple, message_.joint_names[i]);
    columns_.push_back(i);
    joints_.push_back(static_cast<std::size_t>(&joint - simple.joints.data()));
  }
  if (message_.points.size() < 2)
    refuse("trajectory.points has " + std::to_string(message_.points.size()) +
           "; a path needs two or more, the first of them where the motion begins");
  for (std::size_t i = 0; i < message_.points.size(); ++i)
    check(i);
  for (std::size_t i = 0; i < segments(); ++i) {
    if (!motion(i).isFinite())
      refuse("the motion to " + pointName(i + 1) + " is not finite; its numbers are too large");
  }
}

void PlannedTrajectory::check(std::size_t index) const {
  const Point& point = message_.points[index];
  checkNumbers(index, "positions", point.positions);
  if (!point.velocities.empty()) checkNumbers(index, "velocities", point.velocities);
  if (!point.accelerations.empty()) checkNumbers(index, "accelerations", point.accelerations);
  if (index == 0 || point.velocities.empty()) return;
  const Point& before = message_.points[index - 1];
  if (!before.velocities.empty() && !(point.time_from_start > before.time_from_start))
    refuse("time_from_start of " + pointName(index) + " is not after that of " +
           pointName(index - 1) + "; with velocities, times must grow");
}

void PlannedTrajectory::checkNumbers(std::size_t index, const char* what,
                                     const std::vector<double>& numbers) const {
  const std::vector<std::string>& names = message_.joint_names;
  if (numbers.size() != names.size())
    refuse(pointName(index) + " has " + std::to_string(numbers.size()) + " " + what +
           ", but the trajectory has " + std::to_string(names.size()) +
           " joint_names; give one for each");
  const auto wrong =
      std::find_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
  if (wrong == numbers.end()) return;
  const std::string& name = names[static_cast<std::size_t>(wrong - numbers.begin())];
  refuse(std::string(what) + " of " + pointName(index) + ": that of joint \"" + name + "\" is " +
         std::to_string(*wrong) + ", but must be a finite number");
}

JointMotion PlannedTrajectory::motion(std::size_t segment) const {
  return {wayPoint(message_.points[segment]), wayPoint(message_.points[segment + 1])};
}

WayPoint PlannedTrajectory::wayPoint(const Point& point) const {
  return {spread(point.positions), spread(point.velocities), spread(point.accelerations),
          point.time_from_start.toSec()};
}

/// Numbers of the message as one per joint of the robot, 0 for joints that the trajectory does not
/// set. Empty if `numbers` is empty.
std::vector<double> PlannedTrajectory::spread(const std::vector<double>& numbers) const {
  if (numbers.empty()) return {};
  std::vector<double> result(joint_count_, 0.0);
  for (std::size_t i = 0; i < joints_.size(); ++i)
    result[joints_[i]] = numbers[columns_[i]];
  return result;
}

std::vector<Limits> PlannedTrajectory::ranges() const {
  std::vector<Limits> all;
  for (std::size_t segment = 0; segment < segments(); ++segment)
    all = motion(segment).ranges(all);
  return all;
}

}  // namespace link_bounds

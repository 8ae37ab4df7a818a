// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/filter_health.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/console.h>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "node/inputs/tf_receiver.h"
#include "node/upkeep/status.h"
#include "world/log/guarded.h"

namespace link_bounds {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kMaxReasons = 20;  // lines in one status

std::string text(double value, int decimals) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << value;
  return out.str();
}

bool filtersAnything(const FilteredRobot& robot) {
  return std::any_of(robot.grids.begin(), robot.grids.end(),
                     [](const auto& grid) { return !grid->box().isEmpty(); });
}

}  // namespace

FilterHealth::FilterHealth(ros::NodeHandle& node, std::string name)
    : name_(std::move(name)),
      publisher_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1)) {}

void FilterHealth::addFiltered(std::size_t points, std::size_t robot_points, double waited_ms,
                               double filter_ms) {
  ++filtered_;
  points_ += points;
  robot_points_ += robot_points;
  filter_ms_.push_back(filter_ms);
  max_waited_ms_ = std::max(max_waited_ms_, waited_ms);
}

void FilterHealth::addReason(const std::string& reason, Reasons& reasons) {
  if (reasons.size() < kMaxReasons || reasons.count(reason) > 0) ++reasons[reason];
}

void FilterHealth::addUnfiltered(const std::string& topic, const std::string& reason,
                                 bool is_passed) {
  ++(is_passed ? passed_ : dropped_);
  addReason(reason, new_reasons_);
  const std::string line = log_.line(
      "a message on " + topic +
          (is_passed ? " was passed on with the points of the robot: " : " was dropped: ") + reason,
      ros::SteadyTime::now());
  if (!line.empty()) ROS_WARN("%s", logText(line).c_str());
}

void FilterHealth::publish(const FilteredRobot* robot, const std::vector<std::string>& problems,
                           std::size_t waiting, std::size_t most_waiting) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double seconds = std::max((now - last_status_).toSec(), 1e-3);
  last_status_ = now;
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  DiagnosticStatus& status = message.status.emplace_back();
  status.name = name_ + ": cloud filter";
  status.hardware_id = "none";
  if (!robot) raise(status, DiagnosticStatus::ERROR, "no robot has been loaded yet");
  const std::uint64_t errors = unexpectedErrors();
  if (const std::uint64_t count = errors - std::exchange(last_errors_, errors); count > 0)
    raise(status, DiagnosticStatus::ERROR, std::to_string(count) + kUnexpectedErrors);
  if (robot && !filtersAnything(*robot))
    raise(status, DiagnosticStatus::ERROR, "no link of the robot is filtered");
  if (robot && !robot->problems.empty())
    raise(status, DiagnosticStatus::WARN, "geometry of the robot is missing or a convex hull");
  if (!problems.empty())
    raise(status, DiagnosticStatus::WARN,
          "objects that the robot holds are not filtered as they are");
  if (!new_reasons_.empty())
    raise(status, DiagnosticStatus::WARN, "clouds or scans were not filtered");
  if (!without_nearest_.empty())
    raise(status, DiagnosticStatus::WARN, "nearest points of clouds are missing");
  if (new_full_ > 0)
    raise(status, DiagnosticStatus::WARN,
          "clouds or scans may have been lost, because filtering took too long");
  if (late_turns_ > 0)
    raise(status, DiagnosticStatus::WARN,
          "clouds or scans are sent late, because filtering takes longer than they take to come");
  if (was_tf_full_)
    raise(status, DiagnosticStatus::WARN,
          "transforms may have been lost, because filtering took too long");
  if (status.message.empty() && filter_ms_.empty())
    raise(status, DiagnosticStatus::WARN,
          "no cloud or scan has been filtered since the last status");
  if (status.message.empty()) status.message = "filtering";
  std::sort(filter_ms_.begin(), filter_ms_.end());
  const double all_points = static_cast<double>(points_);
  add(status, "points per second", text(all_points / seconds, 0));
  add(status, "robot points [%]",
      text(points_ ? 100 * static_cast<double>(robot_points_) / all_points : 0, 2));
  if (!filter_ms_.empty()) {
    add(status, "per cloud, median [ms]", text(filter_ms_[filter_ms_.size() / 2], 2));
    add(status, "per cloud, max [ms]", text(filter_ms_.back(), 2));
    add(status, "wait for tf and turn, max [ms]", text(max_waited_ms_, 1));
  }
  add(status, "waiting", std::to_string(waiting));
  add(status, "filtered", std::to_string(filtered_));
  add(status, "dropped", std::to_string(dropped_));
  add(status, "times that a queue of clouds was full", std::to_string(full_));
  add(status, "most messages that waited, last second", std::to_string(most_waiting));
  add(status, "passed unfiltered", std::to_string(passed_));
  for (const auto& [reason, count] : new_reasons_)
    add(status, "not filtered: " + reason, std::to_string(count));
  for (const auto& [reason, count] : without_nearest_)
    add(status, "no ~nearest: " + reason, std::to_string(count));
  if (robot) {
    add(status, "left out", robot->left_out.empty() ? "none" : robot->left_out);
    for (const std::string& problem : robot->problems)
      add(status, "problem", problem);
  }
  for (const std::string& problem : problems)
    add(status, "problem", problem);
  publisher_.publish(message);
  points_ = robot_points_ = 0;
  filter_ms_.clear();
  max_waited_ms_ = 0;
  new_reasons_.clear();
  without_nearest_.clear();
  new_full_ = late_turns_ = 0;
  was_tf_full_ = false;
}

}  // namespace link_bounds

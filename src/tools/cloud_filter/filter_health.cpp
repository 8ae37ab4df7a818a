// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/filter_health.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/console.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <utility>

#include "node/inputs/tf_receiver.h"
#include "node/upkeep/status.h"
#include "world/log/guarded.h"

namespace link_bounds {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kMaxReasons = 20;  // rows of a status; one more counts all others
constexpr char kOtherReasons[] = "other reasons";

std::string text(double value, int decimals) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << value;
  return out.str();
}

/// Removes numbers, so that texts that differ only in times are counted together. Keeps the digits
/// of names, which are in quotes or have letters.
std::string withoutNumbers(const std::string& text) {
  std::string result;
  bool is_quoted = false, is_name = false;
  for (const char c : text) {
    const bool is_letter = std::isalpha(static_cast<unsigned char>(c)) || c == '_';
    is_quoted ^= c == '"';
    is_name = c != ' ' && (is_name || is_letter);
    if (is_quoted || is_name || c < '0' || c > '9') result += c;
  }
  return result;
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
  recent_.points += points;
  recent_.robot_points += robot_points;
  recent_.filter_ms.push_back(filter_ms);
  recent_.max_waited_ms = std::max(recent_.max_waited_ms, waited_ms);
}

void FilterHealth::addReason(const std::string& reason, Reasons& reasons) {
  const std::string key = withoutNumbers(reason);
  const bool has_place = reasons.size() < kMaxReasons || reasons.count(key) > 0;
  Reason& found = reasons[has_place ? key : kOtherReasons];
  found.text = has_place ? reason : kOtherReasons;
  ++found.count;
}

void FilterHealth::addUnfiltered(const std::string& topic, const std::string& reason,
                                 bool is_passed) {
  ++(is_passed ? passed_ : dropped_);
  addReason(reason, recent_.unfiltered);
  log(topic, "a message on " + topic +
                 (is_passed ? " was passed on with the points of the robot: " : " was dropped: ") +
                 reason);
}

void FilterHealth::addWithoutNearest(const std::string& reason) {
  addReason(reason, recent_.without_nearest);
  log("~nearest", "no ~nearest: " + reason);
}

void FilterHealth::log(const std::string& topic, const std::string& text) {
  const std::string line = logs_[topic].line(text, ros::SteadyTime::now());
  if (!line.empty()) ROS_WARN("%s", logText(line).c_str());
}

void FilterHealth::assess(DiagnosticStatus& status, const FilteredRobot* robot,
                          const std::string& failure, bool are_objects_whole) {
  if (!robot)
    raise(status, DiagnosticStatus::ERROR,
          failure.empty() ? "no robot has been loaded yet"
                          : "no robot can be loaded: " + failure + "; then call ~reload");
  const std::uint64_t errors = unexpectedErrors();
  if (const std::uint64_t count = errors - std::exchange(last_errors_, errors); count > 0)
    raise(status, DiagnosticStatus::ERROR, std::to_string(count) + kUnexpectedErrors);
  if (robot && !filtersAnything(*robot))
    raise(status, DiagnosticStatus::ERROR, "no link of the robot is filtered");
  const auto warn_if = [&](bool condition, const char* text) {
    if (condition) raise(status, DiagnosticStatus::WARN, text);
  };
  warn_if(robot && !robot->problems.empty(), "geometry of the robot is missing or a convex hull");
  warn_if(!are_objects_whole, "objects that the robot holds are not filtered as they are");
  warn_if(!recent_.unfiltered.empty(), "clouds or scans were not filtered");
  warn_if(!recent_.without_nearest.empty(), "nearest points of clouds are missing");
  warn_if(recent_.full > 0, "clouds or scans may have been lost, because filtering took too long");
  warn_if(recent_.late_turns > 0,
          "clouds or scans are sent late, because filtering takes longer than they take to come");
  warn_if(recent_.was_tf_full, "transforms may have been lost, because filtering took too long");
  warn_if(status.message.empty() && recent_.filter_ms.empty(),
          "no cloud or scan has been filtered since the last status");
  if (status.message.empty()) status.message = "filtering";
}

void FilterHealth::describe(DiagnosticStatus& status, double seconds) {
  std::vector<double>& filter_ms = recent_.filter_ms;
  std::sort(filter_ms.begin(), filter_ms.end());
  const auto all_points = static_cast<double>(recent_.points);
  const auto robot_points = static_cast<double>(recent_.robot_points);
  add(status, "points per second", text(all_points / seconds, 0));
  add(status, "robot points [%]",
      text(recent_.points > 0 ? 100 * robot_points / all_points : 0, 2));
  if (filter_ms.empty()) return;
  add(status, "per cloud, median [ms]", text(filter_ms[filter_ms.size() / 2], 2));
  add(status, "per cloud, max [ms]", text(filter_ms.back(), 2));
  add(status, "wait for tf and turn, max [ms]", text(recent_.max_waited_ms, 1));
}

void FilterHealth::publish(const FilteredRobot* robot, const std::string& failure,
                           const std::vector<std::string>& problems, std::size_t waiting,
                           std::size_t max_waiting) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double seconds = std::max((now - last_status_).toSec(), 1e-3);
  last_status_ = now;
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  DiagnosticStatus& status = message.status.emplace_back();
  status.name = name_ + ": cloud filter";
  status.hardware_id = "none";
  assess(status, robot, failure, problems.empty());
  describe(status, seconds);
  add(status, "waiting", std::to_string(waiting));
  add(status, "filtered", std::to_string(filtered_));
  add(status, "dropped", std::to_string(dropped_));
  add(status, "times that a queue of clouds was full", std::to_string(full_));
  add(status, "most messages that waited, last second", std::to_string(max_waiting));
  add(status, "passed unfiltered", std::to_string(passed_));
  for (const auto& [key, reason] : recent_.unfiltered)
    add(status, "not filtered: " + reason.text, std::to_string(reason.count));
  for (const auto& [key, reason] : recent_.without_nearest)
    add(status, "no ~nearest: " + reason.text, std::to_string(reason.count));
  if (robot) {
    add(status, "left out", robot->left_out.empty() ? "none" : robot->left_out);
    for (const std::string& problem : robot->problems)
      add(status, "problem", problem);
  }
  for (const std::string& problem : problems)
    add(status, "problem", problem);
  publisher_.publish(message);
  recent_ = {};
}

}  // namespace link_bounds

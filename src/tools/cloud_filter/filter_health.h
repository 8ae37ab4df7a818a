// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The status of the filter on /diagnostics.
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/cloud_filter/filtered_robot.h"
#include "world/log/repeat_log.h"

namespace link_bounds {

class FilterHealth {
 public:
  /// `name` is the name of the node.
  FilterHealth(ros::NodeHandle& node, std::string name);

  /// roscpp drops messages silently when a queue is full. The queue of an input therefore holds one
  /// message more than may wait: whenever it was full, the filter drops at least one itself and
  /// reports it.
  static constexpr std::uint32_t kMaxWaiting = 32;  // messages of an input that wait
  static constexpr std::uint32_t kQueue = kMaxWaiting + 1;

  /// The queue of an input was full, so roscpp may have dropped messages of it.
  void addFullQueue() { ++recent_.full, ++full_; }

  /// The queue of /tf was full, so roscpp may have dropped transforms.
  void addFullTfQueue() { recent_.was_tf_full = true; }

  /// A cloud or scan was filtered. `waited_ms` is its wait for tf and its turn, `filter_ms` the
  /// filtering.
  void addFiltered(std::size_t points, std::size_t robot_points, double waited_ms,
                   double filter_ms);

  /// A cloud or scan was filtered too late, because others took too long.
  void addLateTurn() { ++recent_.late_turns; }

  /// A cloud or scan was dropped or, if `is_passed`, sent on with the points of the robot. Logs it
  /// at a limited rate.
  void addUnfiltered(const std::string& topic, const std::string& reason, bool is_passed);

  /// A cloud was filtered, but its nearest points are missing, although ~nearest has a subscriber.
  /// Logs that, at a limited rate.
  void addWithoutNearest(const std::string& reason);

  /// Publishes one status named "<node name>: cloud filter". ERROR: there is no robot, none of its
  /// links is filtered, or an unexpected error occurred since the last status. WARN: geometry or
  /// held objects are missing, or since the last status clouds were not filtered, late or lacked
  /// nearest points, or none was filtered. Else OK. `robot` may be null; `failure` says why it
  /// cannot be loaded. `problems` are about held objects. `waiting` is the number of messages that
  /// wait, `max_waiting` the max number of callbacks that waited at once since the last status.
  void publish(const FilteredRobot* robot, const std::string& failure,
               const std::vector<std::string>& problems, std::size_t waiting,
               std::size_t max_waiting);

 private:
  struct Reason {
    std::string text;  ///< of the last occurrence
    std::size_t count = 0;
  };

  /// The keys are the texts without numbers.
  using Reasons = std::map<std::string, Reason>;

  /// Since the last status.
  struct Recent {
    std::size_t points = 0, robot_points = 0;
    std::vector<double> filter_ms;
    double max_waited_ms = 0;
    std::uint64_t full = 0, late_turns = 0;
    bool was_tf_full = false;
    Reasons unfiltered;       ///< why clouds were not filtered
    Reasons without_nearest;  ///< why filtered clouds have no nearest points
  };

  static void addReason(const std::string& reason, Reasons& reasons);
  void log(const std::string& topic, const std::string& text);
  void assess(diagnostic_msgs::DiagnosticStatus& status, const FilteredRobot* robot,
              const std::string& failure, bool are_objects_whole);
  void describe(diagnostic_msgs::DiagnosticStatus& status, double seconds);

  std::string name_;
  ros::Publisher publisher_;
  ros::SteadyTime last_status_ = ros::SteadyTime::now();
  Recent recent_;
  // Since the start:
  std::uint64_t filtered_ = 0, dropped_ = 0, passed_ = 0, full_ = 0;
  std::uint64_t last_errors_ = 0;          ///< unexpectedErrors() at the last status
  std::map<std::string, RepeatLog> logs_;  ///< by topic
};

}  // namespace link_bounds

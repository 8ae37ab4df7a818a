// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The status of the node on /diagnostics.
#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "node/outputs/distance_output.h"
#include "node/threads/callback_times.h"
#include "world/bodies/scene.h"
#include "world/tf/transform_input.h"

namespace link_bounds {

/// The parts of the status that do not come from the scene.
struct Health {
  std::string awaited_description;  ///< name of the awaited parameter; "" if not waiting
  bool waits_for_clock = false;
  bool clock_jumped = false;       ///< in the last five seconds
  std::uint64_t clock_jumps = 0;   ///< number of backward jumps since the start
  std::uint64_t updates = 0;       ///< changes of the scene, since the start
  std::uint64_t publications = 0;  ///< of ~boxes, since the start
  std::uint64_t errors = 0;        ///< unexpectedErrors(), since the start
  std::size_t joined = 0;          ///< messages whose update was joined with a later one, since the
                                   ///< last status
  std::size_t skipped = 0;         ///< messages of /tf that were not read, since the last status
  std::size_t max_waiting = 0;     ///< max number of messages and other events that waited at the
                                   ///< same time, since the last status
  std::optional<double> lag_ms;    ///< max lag of a stamp behind ROS time since the last status: of
                                   ///< ~boxes when published, of transforms when received
  double delay_ms = 0;             ///< max time from the arrival of a message until it was handled,
                                   ///< since the last status
  std::string footprint;           ///< whether ~footprint is published; if not, the reason
  std::string stopping;            ///< why boxes of ~stopping are missing; "" if none is
  std::string earliest;            ///< why bodies of ~earliest are missing; "" if none is
  std::map<std::string, double> behind;  ///< per topic, without ~: max delay of its computation
                                         ///< behind ~boxes since the last status [s]
  TfIntake intake;
  LateTexts late_publishers;
  DistanceHealth distances;
};

class Diagnostics {
 public:
  explicit Diagnostics(ros::NodeHandle& node);

  /// Publishes one status named "<node name>: boxes". See doc/deployment.md for its levels. Resets
  /// the period of `times`.
  void publish(const Scene& scene, const Health& health, CallbackTimes& times);

 private:
  double secondsSinceLast();

  ros::Publisher publisher_;
  ros::SteadyTime last_status_ = ros::SteadyTime::now();
  std::uint64_t last_updates_ = 0;  ///< value of Health::updates at last_status_
  std::uint64_t last_errors_ = 0;
};

}  // namespace link_bounds

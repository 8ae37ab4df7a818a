// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the node reports about itself.
#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "node/outputs/distance_output.h"
#include "node/upkeep/callback_times.h"
#include "world/bodies/scene.h"
#include "world/tf/late_publishers.h"

namespace link_bounds {

/// What cannot be read from the scene.
struct Health {
  std::string awaited_description;  ///< name of the parameter; empty: not waited for
  bool waits_for_clock = false;
  bool clock_jumped = false;       ///< in the last five seconds
  std::uint64_t clock_jumps = 0;   ///< back, since the start
  std::uint64_t updates = 0;       ///< changes of the scene, since the start
  std::uint64_t publications = 0;  ///< of ~boxes, since the start
  std::uint64_t errors = 0;        ///< unexpectedErrors(), since the start
  std::size_t joined = 0;          ///< messages that shared an update with a later one, since the
                                   ///< last status
  std::size_t skipped = 0;         ///< messages of /tf that were not read, since the last status
  std::size_t max_waiting = 0;     ///< messages and other events at once, since the last status
  std::optional<double> lag_ms;    ///< by how much a new stamp of a ~boxes lay behind ROS time when
                                   ///< it was published, or that of a transform when it came; the
                                   ///< maximum since the last status
  double delay_ms = 0;             ///< from the arrival of a message until it was handled; the
                                   ///< maximum since the last status
  std::string footprint;           ///< whether ~footprint is published, and if not, why
  std::string stopping;            ///< why boxes of ~stopping are missing; "": none is
  std::string earliest;            ///< why bodies of ~earliest are missing; "": none is
  std::map<std::string, double> behind;  ///< by topic without ~: for how long its computation was
                                         ///< behind ~boxes [s], the maximum since the last status
  TfIntake intake;
  LatePublishers::Texts late_publishers;
  DistanceHealth distances;
};

class Diagnostics {
 public:
  explicit Diagnostics(ros::NodeHandle& node);

  /// Publishes one status named "<node name>: boxes". Its levels are those of doc/deployment.md.
  /// `times` begins a new period.
  void publish(const Scene& scene, const Health& health, CallbackTimes& times);

 private:
  double secondsSinceLast();

  ros::Publisher publisher_;
  ros::SteadyTime last_status_ = ros::SteadyTime::now();
  std::uint64_t last_updates_ = 0;  ///< at last_status_
  std::uint64_t last_errors_ = 0;
};

}  // namespace link_bounds

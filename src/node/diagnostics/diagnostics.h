// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the node tells about its health.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <cstdint>
#include <optional>
#include <string>

#include "node/diagnostics/duration_histogram.h"
#include "node/scene/scene.h"

namespace link_bounds {

/// What cannot be read off the boxes.
struct Health {
  bool waits_for_description = false;
  bool waits_for_clock = false;
  bool clock_jumped = false;           ///< in the last five seconds
  std::uint64_t updates = 0;           ///< tf messages that changed something
  std::uint64_t publications = 0;      ///< of ~boxes
  double longest_callback_ms = 0;      ///< wall time of the slowest callback of the update thread
  double longest_callback_cpu_ms = 0;  ///< the most CPU time one of them took
  DurationHistogram tf_callbacks_ms;   ///< wall time, one per tf message received
  double updates_per_second = 0;       ///< since the last status, wall time
  std::optional<double> lag_ms;  ///< the longest since the last status that the newest stamp of a
                                 ///< ~boxes lay behind ROS time when it was published
  TfIntake intake;
};

/// One status named "<node name>: boxes". ERROR: there is no model, or not one box though links
/// are bounded. WARN: something is incomplete or waited for, or the clock jumped. Else OK.
diagnostic_msgs::DiagnosticArray diagnose(const Scene& scene, const Health& health);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits the rate of an output.
#pragma once

#include <ros/time.h>

#include <functional>
#include <optional>

#include "node/threads/periodic.h"
#include "world/log/guarded.h"

namespace link_bounds {

/// Calls `emit` at once for a request that comes at least one period of wall time after the last
/// call. Earlier requests lead to one call when the period, and the patience, is over.
class PacedOutput {
 public:
  /// After the period, markers wait for the next request for this part of a period. tf comes at a
  /// steady rate, typically a multiple of the rate of markers: when the period ends, the next
  /// message comes, too, and drawing would take the processor from its boxes. With this patience,
  /// the 99th percentile of their age was 0.96 of that without markers; before, 2 to 3 times
  /// (`scripts/bench overload --stopping`).
  static constexpr double kPatienceOfMarkers = 0.25;

  /// For a request that waits, `periodic` calls `emit` through `guard`, 1 + `patience` periods
  /// after the last call. `periodic` must outlive this, but must call no alarms after the end of
  /// this.
  PacedOutput(Periodic& periodic, Guard guard, std::function<void()> emit, double patience = 0);
  PacedOutput(const PacedOutput&) = delete;
  PacedOutput& operator=(const PacedOutput&) = delete;

  /// Sets the max rate [Hz]; 0: no limit. Also applies to a request that waits.
  void setRate(double rate);

  void request();

  bool isLimited() const { return period_ > ros::WallDuration(0); }

  /// Calls `emit` at once, whatever the rate.
  void emitNow();

 private:
  void setAlarm();

  /// Does nothing if no request waits: `guard` itself may have led to a request, which was answered
  /// at once.
  void emitWaiting();

  Periodic& periodic_;
  Guard guard_;
  std::function<void()> emit_;
  double patience_;
  ros::WallDuration period_;
  std::optional<ros::SteadyTime> last_;  ///< of the last call
  bool is_waiting_ = false;              ///< a request has not led to a call of `emit` yet
  Periodic::Alarm alarm_;
};

}  // namespace link_bounds

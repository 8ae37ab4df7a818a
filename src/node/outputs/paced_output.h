// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Emits the newest state, at most so often.
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <functional>

#include "node/log/guarded.h"

namespace link_bounds {

/// Calls `emit` at once when a request comes later than one period after the last emission, else
/// when that period is over, once for all requests in between. Wall time.
class PacedOutput {
 public:
  /// `guard` runs what the timer calls.
  PacedOutput(ros::NodeHandle& node, Guard guard, std::function<void()> emit);

  /// Hz; 0 = no limit. It holds at once, also for what waits already.
  void setRate(double rate);

  void request();

  /// Emits now, whatever the rate.
  void emitNow();

 private:
  void startTimer();

  Guard guard_;
  std::function<void()> emit_;
  double period_ = 0;  ///< s
  double last_ = 0;    ///< s, wall time; 0 = never
  ros::WallTimer timer_;
  bool is_waiting_ = false;
};

}  // namespace link_bounds

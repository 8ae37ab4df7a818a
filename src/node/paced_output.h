// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Emits the newest state, at most so often.
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <functional>

namespace link_bounds {

/// Calls `emit` at once when a request comes later than one period after the last emission, else
/// when that period is over, once for all requests in between. Wall time.
class PacedOutput {
 public:
  PacedOutput(ros::NodeHandle& node, std::function<void()> emit);

  /// Hz; 0 = no limit.
  void setRate(double rate);

  void request();

  /// Emits now, whatever the rate.
  void emitNow();

 private:
  std::function<void()> emit_;
  ros::WallDuration period_;
  ros::WallTime last_;
  ros::WallTimer timer_;
  bool is_waiting_ = false;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits the rate of an output.
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <functional>

#include "node/log/guarded.h"

namespace link_bounds {

/// Calls `emit` at once for a request that comes at least one period of wall time after the last
/// call. Earlier requests lead to one call when the period is over.
class PacedOutput {
 public:
  /// `guard` runs `emit` when the timer calls it.
  PacedOutput(ros::NodeHandle& node, Guard guard, std::function<void()> emit);
  PacedOutput(const PacedOutput&) = delete;
  PacedOutput& operator=(const PacedOutput&) = delete;

  /// In Hz; 0 = no limit. Also applies to a request that waits.
  void setRate(double rate);

  void request();

  /// True if a request has not led to a call yet.
  bool isWaiting() const { return is_waiting_; }

  /// Calls `emit` now, at any rate.
  void emitNow();

 private:
  void startTimer();

  Guard guard_;
  std::function<void()> emit_;
  double period_ = 0;  ///< s
  double last_ = 0;    ///< of the last call [s], wall time; 0 = never
  ros::WallTimer timer_;
  bool is_waiting_ = false;
};

}  // namespace link_bounds

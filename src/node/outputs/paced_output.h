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
/// call. Earlier requests lead to one call when the period is over.
class PacedOutput {
 public:
  /// `periodic`, which must outlive this, has `guard` call `emit` when a period is over.
  PacedOutput(Periodic& periodic, Guard guard, std::function<void()> emit);
  PacedOutput(const PacedOutput&) = delete;
  PacedOutput& operator=(const PacedOutput&) = delete;

  /// In Hz; 0 = no limit. Also applies to a request that waits.
  void setRate(double rate);

  void request();

  bool isLimited() const { return period_ > ros::WallDuration(0); }

  /// Calls `emit` at once, whatever the rate.
  void emitNow();

 private:
  Periodic& periodic_;
  Guard guard_;
  std::function<void()> emit_;
  ros::WallDuration period_;
  std::optional<ros::SteadyTime> last_;  ///< of the last call
  bool is_waiting_ = false;              ///< a request has not led to a call yet
  Periodic::Alarm alarm_;
};

}  // namespace link_bounds

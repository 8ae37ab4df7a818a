// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Watches ROS time: whether it runs, and whether it jumps.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>

namespace link_bounds {

class ClockWatch {
 public:
  enum class Event { kNone, kStarted, kJumpedAhead, kJumpedBack };

  /// `steady_now` never goes back: the steady clock, or the recorded time of a bag so far.
  explicit ClockWatch(std::function<ros::SteadyTime()> steady_now = ros::SteadyTime::now);

  /// Compares `now` with earlier observations. Steps back of up to 0.1 s are no jump, nor are steps
  /// ahead of up to 2 s.
  Event observe(ros::Time now);

  /// True for a stamp more than 0.5 s ahead of `now` in a message that arrived at most 0.5 s of
  /// steady time after the last jump back, or before it: the transform was sent before the jump.
  /// The time that the message then waited does not count.
  bool isFromBeforeJump(ros::Time stamp, ros::Time now, ros::SteadyTime arrival) const;

  /// Whether observe() would see a jump back.
  bool isJumpBack(ros::Time now) const;

  /// Jumps back since construction.
  std::uint64_t jumps() const { return jumps_; }

  /// True for five seconds of steady time after a jump.
  bool hasJustJumped() const;

  /// True if simulated time is in use and has not begun five seconds after construction.
  bool isMissing() const;

 private:
  std::function<ros::SteadyTime()> steady_now_;
  ros::Time last_;  ///< the newest time since the last jump back
  ros::SteadyTime start_;
  ros::SteadyTime jump_;  ///< time of the last jump back; zero if there was none
  std::uint64_t jumps_ = 0;
};

}  // namespace link_bounds

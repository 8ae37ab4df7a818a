// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Jumps are jumps of ROS time. The time since a jump is measured by the steady clock.
#include "world/tf/clock_watch.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

constexpr double kMinJump = 0.1;       // s
constexpr double kMinJumpAhead = 2.0;  // s
constexpr double kJumpAhead = 0.5;     // s
const ros::WallDuration kLateArrivals(0.5);
const ros::WallDuration kReportJump(5.0);
const ros::WallDuration kClockTimeout(5.0);

/// From `earlier` to `later` [s]. Subtracting ros::Time throws if a ros::Duration cannot hold the
/// result.
double since(ros::Time earlier, ros::Time later) {
  return static_cast<double>(nanosecondsOf(later) - nanosecondsOf(earlier)) / 1e9;
}

}  // namespace

ClockWatch::ClockWatch(std::function<ros::SteadyTime()> steady_now)
    : steady_now_(std::move(steady_now)), start_(steady_now_()) {}

ClockWatch::Event ClockWatch::observe(ros::Time now) {
  const ros::Time last = last_;
  // A small step back does not change `last_`, so that many such steps add up to a jump.
  if (!isJumpBack(now)) {
    last_ = std::max(last, now);
    if (last.isZero()) return now.isZero() ? Event::kNone : Event::kStarted;
    return since(last, now) > kMinJumpAhead ? Event::kJumpedAhead : Event::kNone;
  }
  last_ = now;
  jump_ = steady_now_();
  ++jumps_;
  return Event::kJumpedBack;
}

bool ClockWatch::isJumpBack(ros::Time now) const {
  return since(now, last_) > kMinJump;
}

bool ClockWatch::isFromBeforeJump(ros::Time stamp, ros::Time now, ros::SteadyTime arrival) const {
  if (jump_.isZero() || since(now, stamp) <= kJumpAhead) return false;
  return arrival - jump_ <= kLateArrivals;
}

bool ClockWatch::hasJustJumped() const {
  return !jump_.isZero() && steady_now_() - jump_ < kReportJump;
}

bool ClockWatch::isMissing() const {
  return ros::Time::isSimTime() && last_.isZero() && steady_now_() - start_ > kClockTimeout;
}

}  // namespace link_bounds

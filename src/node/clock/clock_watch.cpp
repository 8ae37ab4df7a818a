// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Durations of wall time are measured on the steady clock.
#include "node/clock/clock_watch.h"

#include <algorithm>
#include <cstdint>

namespace link_bounds {
namespace {

constexpr double kSmallestJump = 0.1;  // s
constexpr double kFarAhead = 0.5;      // s
const ros::WallDuration kDoubtAfterJump(0.5);
const ros::WallDuration kNewsOfJump(5.0);
const ros::WallDuration kPatience(5.0);

/// Seconds; the difference of two ros::Time throws when it is too large for a ros::Duration.
double since(ros::Time earlier, ros::Time later) {
  const auto nanoseconds = [](ros::Time time) { return static_cast<std::int64_t>(time.toNSec()); };
  return static_cast<double>(nanoseconds(later) - nanoseconds(earlier)) / 1e9;
}

}  // namespace

ClockWatch::ClockWatch() : start_(ros::SteadyTime::now()) {}

ClockWatch::Event ClockWatch::observe(ros::Time now) {
  const ros::Time last = last_;
  // Small steps back are no jump, and do not add up to one that goes unnoticed.
  if (since(now, last) <= kSmallestJump) {
    last_ = std::max(last, now);
    return last.isZero() && !now.isZero() ? Event::kStarted : Event::kNone;
  }
  last_ = now;
  jump_ = ros::SteadyTime::now();
  return Event::kJumpedBack;
}

bool ClockWatch::isFromBeforeJump(ros::Time stamp, ros::Time now) const {
  if (jump_.isZero() || since(now, stamp) <= kFarAhead) return false;
  return ros::SteadyTime::now() - jump_ <= kDoubtAfterJump;
}

bool ClockWatch::hasJustJumped() const {
  return !jump_.isZero() && ros::SteadyTime::now() - jump_ < kNewsOfJump;
}

bool ClockWatch::isMissing() const {
  return ros::Time::isSimTime() && last_.isZero() && ros::SteadyTime::now() - start_ > kPatience;
}

}  // namespace link_bounds

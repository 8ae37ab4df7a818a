// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// An alarm is set while a request waits.
#include "node/outputs/topic/paced_output.h"

#include <algorithm>
#include <utility>

namespace link_bounds {
namespace {

/// Two periods still fit into the 32 bits of seconds that roscpp has.
constexpr double kMaxPeriod = 1e8;  // s

}  // namespace

PacedOutput::PacedOutput(Periodic& periodic, Guard guard, std::function<void()> emit,
                         double patience)
    : periodic_(periodic),
      guard_(std::move(guard)),
      emit_(std::move(emit)),
      patience_(patience),
      alarm_(periodic.addAlarm([this] { guard_([this] { emitWaiting(); }); })) {}

void PacedOutput::setRate(double rate) {
  period_ = ros::WallDuration(rate > 0 ? std::min(1 / rate, kMaxPeriod) : 0);
  if (is_waiting_) setAlarm();
}

void PacedOutput::request() {
  if (!last_ || ros::SteadyTime::now() - *last_ >= period_) return emitNow();
  if (!std::exchange(is_waiting_, true)) setAlarm();
}

void PacedOutput::setAlarm() {
  periodic_.setAlarm(alarm_, *last_ + period_ * (1 + patience_));
}

void PacedOutput::emitWaiting() {
  if (is_waiting_) emitNow();
}

void PacedOutput::emitNow() {
  periodic_.setAlarm(alarm_, std::nullopt);
  is_waiting_ = false;
  last_ = ros::SteadyTime::now();
  emit_();
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A one-shot timer runs while a request waits.
#include "node/outputs/paced_output.h"

#include <algorithm>

namespace link_bounds {
namespace {

/// A period in roscpp must be positive and fit into 32 bits of seconds.
constexpr double kMinWait = 1e-4;  // s
constexpr double kMaxWait = 1e8;   // s

}  // namespace

PacedOutput::PacedOutput(ros::NodeHandle& node, Guard guard, std::function<void()> emit)
    : guard_(std::move(guard)),
      emit_(std::move(emit)),
      timer_(node.createWallTimer(
          ros::WallDuration(1), [this](const ros::WallTimerEvent&) { guard_([&] { emitNow(); }); },
          true, false)) {}

void PacedOutput::setRate(double rate) {
  period_ = rate > 0 ? 1 / rate : 0;
  if (is_waiting_) startTimer();
}

void PacedOutput::request() {
  if (is_waiting_) return;
  const double elapsed = ros::WallTime::now().toSec() - last_;
  // `elapsed` is negative if the wall clock was set back.
  if (elapsed >= period_ || elapsed < 0) return emitNow();
  is_waiting_ = true;
  startTimer();
}

/// Restarts a timer that runs already.
void PacedOutput::startTimer() {
  const double rest = std::min(last_ + period_ - ros::WallTime::now().toSec(), period_);
  timer_.stop();
  timer_.setPeriod(ros::WallDuration(std::clamp(rest, kMinWait, kMaxWait)));
  timer_.start();
}

void PacedOutput::emitNow() {
  timer_.stop();
  is_waiting_ = false;
  last_ = ros::WallTime::now().toSec();
  emit_();
}

}  // namespace link_bounds

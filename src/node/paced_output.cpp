// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A one-shot timer that runs only while something waits.
#include "paced_output.h"

#include <algorithm>

#include "guarded.h"

namespace link_bounds {
namespace {

/// roscpp wants a positive period.
constexpr double kShortestWait = 1e-4;

}  // namespace

PacedOutput::PacedOutput(ros::NodeHandle& node, std::function<void()> emit)
    : emit_(std::move(emit)),
      timer_(node.createWallTimer(
          ros::WallDuration(1), [this](const ros::WallTimerEvent&) { guarded([&] { emitNow(); }); },
          true, false)) {}

void PacedOutput::setRate(double rate) {
  period_ = rate > 0 ? ros::WallDuration(1 / rate) : ros::WallDuration(0);
}

void PacedOutput::request() {
  if (is_waiting_) return;
  const ros::WallDuration elapsed = ros::WallTime::now() - last_;
  // A wall clock set back must not silence the output.
  if (elapsed >= period_ || elapsed < ros::WallDuration(0)) return emitNow();
  is_waiting_ = true;
  timer_.setPeriod(ros::WallDuration(std::max((period_ - elapsed).toSec(), kShortestWait)));
  timer_.start();
}

void PacedOutput::emitNow() {
  timer_.stop();
  is_waiting_ = false;
  last_ = ros::WallTime::now();
  emit_();
}

}  // namespace link_bounds

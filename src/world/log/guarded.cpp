// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Throttles by steady time. ROS_ERROR_THROTTLE uses ROS time, so it prints nothing while /clock is
// missing.
#include "world/log/guarded.h"

#include <ros/console.h>
#include <ros/time.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <mutex>

#include "world/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kPeriod(1.0);

std::atomic<std::uint64_t> errors{0};

}  // namespace

void logUnexpected(const std::exception& error) {
  ++errors;
  static std::mutex mutex;
  static ros::SteadyTime last_line;  // zero before the first
  const std::lock_guard<std::mutex> lock(mutex);
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!last_line.isZero() && now - last_line < kPeriod) return;
  last_line = now;
  ROS_ERROR("unexpected: %s", logText(error.what()).c_str());
}

std::uint64_t unexpectedErrors() {
  return errors;
}

void endWithoutMemory() noexcept {
  constexpr char kLine[] =
      "[FATAL] memory ran out during an update: the node ends, because later results could be "
      "wrong. Give it more memory; roslaunch starts it again with respawn=\"true\"\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kLine, sizeof kLine - 1);
  std::_Exit(1);
}

}  // namespace link_bounds

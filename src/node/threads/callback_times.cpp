// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Wall time comes from the steady clock, CPU time from the CPU clock of the calling thread.
#include "node/threads/callback_times.h"

#include <time.h>

#include <algorithm>

namespace link_bounds {
namespace {

double threadCpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

}  // namespace

void Durations::add(double duration) {
  ++count;
  sum += duration;
  max = std::max(max, duration);
}

CallbackTimes::Start CallbackTimes::begin() {
  return {ros::SteadyTime::now(), threadCpuMilliseconds()};
}

double CallbackTimes::end(const Start& start) {
  const double wall = (ros::SteadyTime::now() - start.wall).toSec() * 1e3;
  longest_ = std::max(longest_, wall);
  longest_cpu_ = std::max(longest_cpu_, threadCpuMilliseconds() - start.cpu_ms);
  return wall;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Wall time by the steady clock, CPU time by that of the calling thread.
#include "node/diagnostics/callback_times.h"

#include <ros/time.h>
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

double CallbackTimes::measure(const std::function<void()>& body) {
  const ros::SteadyTime start = ros::SteadyTime::now();
  const double start_cpu = threadCpuMilliseconds();
  const auto record = [&] {
    const double wall = (ros::SteadyTime::now() - start).toSec() * 1e3;
    longest_ = std::max(longest_, wall);
    longest_cpu_ = std::max(longest_cpu_, threadCpuMilliseconds() - start_cpu);
    return wall;
  };
  try {
    body();
  } catch (...) {
    record();
    throw;
  }
  return record();
}

void CallbackTimes::measureTf(const std::function<void()>& body) {
  const double wall = measure(body);
  tf_.add(wall);
  recent_tf_.add(wall);
}

}  // namespace link_bounds

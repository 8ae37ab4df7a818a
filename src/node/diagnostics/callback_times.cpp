// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Wall time by the steady clock, CPU time by that of the calling thread.
#include "node/diagnostics/callback_times.h"

#include <time.h>

#include <algorithm>
#include <utility>

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

Durations CallbackTimes::takeRecentTf() {
  return std::exchange(recent_tf_, Durations());
}

CallbackTimes::Measurement::Measurement(CallbackTimes& times, bool is_tf)
    : times_(times),
      is_tf_(is_tf),
      start_(ros::SteadyTime::now()),
      start_cpu_(threadCpuMilliseconds()) {}

CallbackTimes::Measurement::~Measurement() {
  const double wall = (ros::SteadyTime::now() - start_).toSec() * 1e3;
  times_.longest_ = std::max(times_.longest_, wall);
  times_.longest_cpu_ = std::max(times_.longest_cpu_, threadCpuMilliseconds() - start_cpu_);
  if (!is_tf_) return;
  times_.tf_.add(wall);
  times_.recent_tf_.add(wall);
}

}  // namespace link_bounds

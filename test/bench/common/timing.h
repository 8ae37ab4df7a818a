// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long a call takes.
#pragma once

#include <time.h>

#include <chrono>
#include <vector>

#include "bench/common/result.h"

namespace link_bounds::bench {

/// The processor time of this thread so far [s], which other programs disturb less than elapsed
/// time.
inline double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

/// The elapsed time of one call, in periods such as std::micro.
template <class Period, class Function>
double elapsed(const Function& function) {
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double, Period>(std::chrono::steady_clock::now() - start).count();
}

/// The median of some calls.
template <class Period, class Function>
double medianTime(int repetitions, const Function& function) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i)
    times.push_back(elapsed<Period>(function));
  return median(times);
}

}  // namespace link_bounds::bench

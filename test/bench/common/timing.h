// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long a call takes.
#pragma once

#include <chrono>
#include <vector>

#include "bench/common/result.h"

namespace link_bounds::bench {

/// The median of some calls, in periods such as std::micro.
template <class Period, class Function>
double medianTime(int repetitions, Function function) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    function();
    times.push_back(
        std::chrono::duration<double, Period>(std::chrono::steady_clock::now() - start).count());
  }
  return median(times);
}

}  // namespace link_bounds::bench

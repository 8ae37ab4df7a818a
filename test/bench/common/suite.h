// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All that is measured in one run, and the run.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <vector>

#include "bench/common/result.h"

namespace link_bounds::bench {

struct Case {
  Result result;                                ///< its time is there after the run
  std::function<void(benchmark::State&)> body;  ///< a loop of Google Benchmark
  std::size_t boxes_per_iteration = 1;
  /// A single box, in the pose of this number; empty if the case is no box of one mesh.
  std::function<void(std::size_t pose)> one_box = {};
};

using Suite = std::vector<Case>;

/// Runs every case for some seconds, all of them in random order, and that as often as `rounds`
/// says; so what slows the machine down for a while strikes no case more than others. A round more
/// comes first, to warm up and to find out how many iterations fill the time.
Results run(const Suite& suite, int rounds, double seconds);

}  // namespace link_bounds::bench

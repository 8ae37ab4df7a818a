// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What all benchmarks have in common around what they measure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/common/row.h"

namespace link_bounds::bench {

/// Measures, prints, and returns the rows.
using Measure = std::function<Rows(bool quick)>;

struct Benchmark {
  std::string name;
  Measure measure;
  Measure cold = nullptr;  ///< with --cold instead, if there is one
};

/// The main function of the program that has these benchmarks: NAME [--cold] [--quick]
/// [--json FILE]. The one named runs on one processor. Errors go to standard error; returns the
/// exit status.
int driveBenchmarks(int argc, char** argv, const std::vector<Benchmark>& benchmarks);

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What all benchmarks have in common around what they measure.
#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace link_bounds::bench {

/// The command line: [--cold] [--quick] [--json FILE]
struct Options {
  bool cold = false;
  bool quick = false;
  std::string json;  ///< "" = none
};

/// Measures, prints, and writes its rows to `json` unless that is null.
using Benchmark = std::function<void(bool quick, std::ostream* json)>;

/// The main function of a benchmark, which then runs on one processor. With --cold it runs `cold`
/// instead, if there is one. Errors go to standard error, with the program's name; returns the exit
/// status.
int runBenchmark(int argc, char** argv, const Benchmark& benchmark,
                 const Benchmark& cold = nullptr);

}  // namespace link_bounds::bench

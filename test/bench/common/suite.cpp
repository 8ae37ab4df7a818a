// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Google Benchmark interleaves repetitions itself from 1.6 on; older systems have 1.5, so here each
// round is a run of its own.
#include "bench/common/suite.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

namespace link_bounds::bench {
namespace {

/// Takes the times instead of printing them. Benchmarks are named by the index of their case.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t count) : iterations(count), seconds(count) {}

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const std::size_t index = std::stoul(run.run_name.function_name);
      iterations[index] = run.iterations;
      seconds[index].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
  }

  std::vector<benchmark::IterationCount> iterations;
  std::vector<std::vector<double>> seconds;  ///< per iteration, one for each round
};

using Setting = std::function<void(std::size_t index, benchmark::internal::Benchmark& benchmark)>;

void runRound(const Suite& suite, const std::vector<std::size_t>& order, const Setting& setting,
              Collector& collector) {
  benchmark::ClearRegisteredBenchmarks();
  for (const std::size_t index : order)
    setting(index, *benchmark::RegisterBenchmark(std::to_string(index).c_str(), suite[index].body));
  benchmark::RunSpecifiedBenchmarks(&collector);
}

}  // namespace

Results run(const Suite& suite, int rounds, double seconds) {
  std::vector<std::size_t> order(suite.size());
  std::iota(order.begin(), order.end(), 0u);
  Collector first(suite.size());
  runRound(
      suite, order, [&](std::size_t, auto& benchmark) { benchmark.MinTime(seconds); }, first);

  Collector collector(suite.size());
  std::mt19937 engine(3);
  const Setting setting = [&first](std::size_t index, auto& benchmark) {
    benchmark.Iterations(first.iterations[index]);
  };
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), engine);
    runRound(suite, order, setting, collector);
  }

  Results results;
  for (std::size_t i = 0; i < suite.size(); ++i) {
    results.push_back(suite[i].result);
    results.back().ns =
        1e9 * median(collector.seconds[i]) / static_cast<double>(suite[i].boxes_per_iteration);
  }
  return results;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One box after each emptying of the caches.
#include "bench/core/cold_boxes.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

#include "bench/common/cold.h"
#include "bench/common/table.h"
#include "bench/common/target.h"
#include "bench/common/timing.h"

namespace link_bounds::bench {
namespace {

constexpr double kMaxTimesCorners = 2.5;

template <class Measured>
double nsOf(const Measured& measured) {
  std::chrono::steady_clock::now();  // brings the clock's own code and data
  return elapsed<std::nano>(measured);
}

/// What the clock itself takes.
double clockNs() {
  std::vector<double> times(1001);
  for (double& time : times)
    time = nsOf([] {});
  return median(times);
}

/// The next case by the same method.
std::size_t neighbour(const Suite& suite, std::size_t index) {
  std::size_t other = index;
  do {
    other = (other + 1) % suite.size();
  } while (suite[other].result.method != suite[index].result.method);
  return other;
}

struct Times {
  std::vector<double> cold;
  std::vector<double> with_warm_code;
};

void measure(const Suite& suite, std::size_t index, std::size_t round, double clock_ns,
             Times& times) {
  const auto box = [&] { suite[index].one_box(round); };
  emptyCaches();
  times.cold.push_back(nsOf(box) - clock_ns);
  emptyCaches();
  suite[neighbour(suite, index)].one_box(round + 1);
  times.with_warm_code.push_back(nsOf(box) - clock_ns);
}

void addResult(Result result, double ns, Results& results) {
  result.ns = ns;
  results.push_back(std::move(result));
}

}  // namespace

std::string withWarmCode(const std::string& method) {
  return method + "_warm_code";
}

Results runCold(const Suite& suite, int rounds) {
  const double clock_ns = clockNs();
  std::vector<std::size_t> order(suite.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Times> times(suite.size());
  std::mt19937 engine(3);
  for (std::size_t round = 0; round < static_cast<std::size_t>(rounds); ++round) {
    std::shuffle(order.begin(), order.end(), engine);
    for (const std::size_t index : order)
      measure(suite, index, round, clock_ns, times[index]);
  }
  Results results;
  for (std::size_t i = 0; i < suite.size(); ++i) {
    Result result = suite[i].result;
    addResult(result, median(times[i].cold), results);
    result.method = withWarmCode(result.method);
    addResult(result, median(times[i].with_warm_code), results);
  }
  return results;
}

void printCold(const Results& results, const std::string& ours) {
  constexpr char kCorners[] = "corners8";
  constexpr char kGeometricShapes[] = "geometric_shapes";
  const Rows rows = rowsOf(results);
  const auto median_of = [&rows](const std::string& method) {
    return median(numbersOf(rows, {{"method", method}, {"kind", "robot"}}, "ns"));
  };
  const Table table("ns per box from empty caches, medians over the robot meshes",
                    {{"method", "", 20}, {"all cold"}, {"code warm"}});
  for (const std::string& method : {ours, std::string(kGeometricShapes), std::string(kCorners)}) {
    table.add({{"method", method},
               {"all cold", median_of(method)},
               {"code warm", median_of(withWarmCode(method))}});
  }
  printTargets(", by medians over the robot meshes",
               {{"cold: " + ours + " / " + kCorners, Wanted::kAtMost, kMaxTimesCorners,
                 ratios(results, ours, kCorners, isRobot)}});
}

}  // namespace link_bounds::bench

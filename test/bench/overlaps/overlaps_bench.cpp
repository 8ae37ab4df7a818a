// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times overlap searches of many moving boxes, ours and others: overlaps_bench [--quick] [--json
// FILE]
#include <iostream>

#include "bench/common/benchmark_main.h"
#include "bench/common/machine.h"
#include "bench/overlaps/overlap_report.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kFewBoxes = 1000;
constexpr std::size_t kManyBoxes = 10000;

/// A peer that is not installed is not compiled.
std::vector<OverlapSetting> overlapSettings() {
  std::vector<OverlapSetting> settings;
  addOurOverlaps(settings);
#ifdef LINK_BOUNDS_WITH_FCL
  addFclOverlaps(settings);
#else
  std::cout << "left out, because this system lacks it: fcl\n";
#endif
#ifdef LINK_BOUNDS_WITH_BULLET
  addBulletOverlaps(settings);
#else
  std::cout << "left out, because this system lacks it: bullet\n";
#endif
  return settings;
}

void benchmarkOverlaps(bool quick, std::ostream* json) {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << "\npeers: " << LINK_BOUNDS_PEERS << "\n\n"
            << std::flush;
  const std::vector<OverlapSetting> settings = overlapSettings();
  OverlapResults results;
  for (const std::size_t count : {kFewBoxes, kManyBoxes}) {
    const int rounds = (quick ? 3 : 11) * (count == kFewBoxes ? 3 : 1);
    for (const OverlapScene& scene : overlapScenes(count)) {
      for (OverlapResult& result : measureOverlaps(settings, scene, rounds))
        results.push_back(std::move(result));
    }
  }
  printOverlaps(results, std::cout);
  printOverlapTargets(results, std::cout);
  if (json) writeOverlapJson(results, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkOverlaps);
}

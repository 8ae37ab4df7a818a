// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Overlaps of many boxes in motion, ours and the peers': overlaps_bench [--quick] [--json FILE]
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "machine.h"
#include "options.h"
#include "overlap_report.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kFewBoxes = 1000;
constexpr std::size_t kManyBoxes = 10000;

/// Peers that are not installed have no file in the build.
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

void benchmarkOverlaps(const Options& options) {
  std::ofstream json;
  if (!options.json.empty()) json.open(options.json);
  if (!json) throw std::runtime_error("cannot write " + options.json);
  pinToOneCpu();
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << "\npeers: " << LINK_BOUNDS_PEERS << "\n\n"
            << std::flush;
  const std::vector<OverlapSetting> settings = overlapSettings();
  OverlapResults results;
  for (const std::size_t count : {kFewBoxes, kManyBoxes}) {
    const int rounds = (options.quick ? 3 : 11) * (count == kFewBoxes ? 3 : 1);
    for (const OverlapScene& scene : overlapScenes(count)) {
      for (OverlapResult& result : measureOverlaps(settings, scene, rounds))
        results.push_back(std::move(result));
    }
  }
  printOverlaps(results, std::cout);
  printOverlapTargets(results, std::cout);
  if (json.is_open()) writeOverlapJson(results, json);
  if (!json.flush()) throw std::runtime_error("cannot write " + options.json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  using namespace link_bounds::bench;
  benchmarkOverlaps(parseOptions(argc, argv));
} catch (const std::exception& error) {
  std::cerr << "overlaps_bench: " << error.what() << "\n";
  return 1;
}

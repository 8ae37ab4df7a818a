// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times overlap searches of many moving boxes, ours and others.
#include "bench/common/benchmarks.h"
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
#endif
#ifdef LINK_BOUNDS_WITH_BULLET
  addBulletOverlaps(settings);
#endif
  return settings;
}

}  // namespace

Rows benchmarkOverlaps(bool quick) {
  const std::vector<OverlapSetting> settings = overlapSettings();
  OverlapResults results;
  for (const std::size_t count : {kFewBoxes, kManyBoxes}) {
    const int rounds = (quick ? 3 : 11) * (count == kFewBoxes ? 3 : 1);
    for (const OverlapScene& scene : overlapScenes(count)) {
      for (OverlapResult& result : measureOverlaps(settings, scene, rounds))
        results.push_back(std::move(result));
    }
  }
  return reportOverlaps(results);
}

}  // namespace link_bounds::bench

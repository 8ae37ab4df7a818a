// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times overlap searches of many moving boxes, ours and others: medians of ratios within rounds,
// because the speed of the machine changes between rounds.
#include <algorithm>
#include <cmath>
#include <set>

#include "bench/common/benchmarks.h"
#include "bench/common/result.h"
#include "bench/common/table.h"
#include "bench/common/target.h"
#include "bench/overlaps/overlap_rounds.h"

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

const char* const kOurs = "ours";
constexpr double kMaxMedian = 1;
constexpr double kMaxOfAnyScene = 2;

bool isSameScene(const OverlapResult& a, const OverlapResult& b) {
  return a.scene == b.scene && a.boxes == b.boxes;
}

double ratio(const OverlapResult& ours, const OverlapResult& peer) {
  std::vector<double> values;
  for (std::size_t i = 0; i < ours.us_per_round.size(); ++i)
    values.push_back(ours.us_per_round[i] / peer.us_per_round[i]);
  return median(values);
}

/// Our time divided by that of the faster peer; NaN without peers.
double ratioToFaster(const OverlapResult& ours, const OverlapResults& results) {
  double largest = std::nan("");
  for (const OverlapResult& peer : results) {
    if (peer.method != kOurs && isSameScene(ours, peer))
      largest = std::fmax(largest, ratio(ours, peer));
  }
  return largest;
}

Rows rowsOf(const OverlapResults& results) {
  Rows rows;
  for (const OverlapResult& result : results) {
    const bool is_ours = result.method == kOurs;
    rows.push_back({{"method", result.method},
                    {"scene", result.scene},
                    {"boxes", result.boxes},
                    {"us_per_step", median(result.us_per_round)},
                    {"pairs", result.pairs},
                    {"setting", result.setting},
                    {"of_faster_peer", is_ours ? Value(ratioToFaster(result, results)) : Value()}});
  }
  return rows;
}

/// For scenes of that many boxes.
std::vector<Target> targetsOf(const OverlapResults& results, std::size_t size) {
  std::vector<double> values;
  for (const OverlapResult& result : results) {
    const bool is_meant = result.method == kOurs && result.boxes == size;
    const double value = is_meant ? ratioToFaster(result, results) : std::nan("");
    if (!std::isnan(value)) values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  std::vector<double> slowest(values);
  if (!values.empty()) slowest.assign(1, values.back());
  const std::string text = "overlaps / faster peer, " + std::to_string(size) + " boxes";
  return {{text, Wanted::kAtMost, kMaxMedian, values},
          {text + ", slowest scene", Wanted::kAtMost, kMaxOfAnyScene, slowest}};
}

void printOverlaps(const Rows& rows) {
  printTable("us per step, medians",
             {{"scene", "", 20},
              {"boxes"},
              {"pairs"},
              {"method", "", 7},
              {"us_per_step", "us"},
              {"of_faster_peer", "of the faster peer's"},
              {"setting", "", 22}},
             rows);
}

void printTargets(const OverlapResults& results) {
  std::set<std::size_t> sizes;
  for (const OverlapResult& result : results)
    sizes.insert(result.boxes);
  std::vector<Target> targets;
  for (const std::size_t size : sizes) {
    for (const Target& target : targetsOf(results, size))
      targets.push_back(target);
  }
  bench::printTargets(" for ours / the faster peer", targets);
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
  const Rows rows = rowsOf(results);
  printOverlaps(rows);
  printTargets(results);
  return rows;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Measures processor time, which other programs disturb less than elapsed time.
#include "bench/overlaps/overlap_rounds.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <tuple>

#include "bench/common/timing.h"

namespace link_bounds::bench {
namespace {

// A method may do most of its work in few of the steps, so a round has many.
constexpr std::size_t kStepsPerRound = 32;
// After each of these rounds, slow settings are dropped and times are forgotten. The last choice
// counts only one round, because trees improve during their first steps.
constexpr int kFirstRounds = 1;
constexpr int kTrialRounds = 4;
constexpr int kChoiceRounds = 5;
constexpr double kHopeless = 6;  ///< times the fastest setting, dropped before the last choice

struct Contender {
  OverlapResult result;
  std::unique_ptr<OverlapMethod> method;
};

using Round = std::vector<SceneBoxes>;

using SortedPairs = std::vector<std::tuple<std::size_t, std::size_t, double>>;

SortedPairs sorted(const std::vector<BoxPair>& pairs) {
  SortedPairs result;
  for (const BoxPair& pair : pairs)
    result.emplace_back(pair.first, pair.second, pair.distance);
  std::sort(result.begin(), result.end());
  return result;
}

/// Takes all steps of a round and appends their mean time. Returns the number of pairs in each
/// step.
std::vector<std::size_t> run(const Round& round, Contender& contender) {
  double sum = 0;
  std::vector<std::size_t> counts;
  for (const SceneBoxes& boxes : round) {
    contender.method->prepare(boxes);
    const double start = threadSeconds();
    contender.method->step(boxes);
    sum += (threadSeconds() - start) * 1e6;
    counts.push_back(contender.method->pairs.size());
  }
  contender.result.us_per_round.push_back(sum / static_cast<double>(round.size()));
  contender.result.pairs = counts.back();
  return counts;
}

void runAll(const Round& round, std::vector<Contender>& contenders, std::mt19937& engine) {
  std::vector<std::size_t> order(contenders.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), engine);
  std::vector<std::size_t> expected;
  for (const std::size_t i : order) {
    const std::vector<std::size_t> counts = run(round, contenders[i]);
    if (expected.empty()) expected = counts;
    if (counts != expected) throw std::runtime_error("the methods find different numbers of pairs");
  }
  const SortedPairs pairs = sorted(contenders.front().method->pairs);
  for (const Contender& contender : contenders) {
    if (sorted(contender.method->pairs) != pairs)
      throw std::runtime_error("the methods find different pairs or distances");
  }
}

Contender makeContender(const OverlapSetting& setting, const std::string& scene,
                        const SceneBoxes& boxes) {
  Contender contender;
  contender.result.method = setting.method;
  contender.result.setting = setting.setting;
  contender.result.scene = scene;
  contender.result.boxes = boxes.size();
  contender.method = setting.make(boxes);
  return contender;
}

double fastestOf(const std::string& method, const std::vector<Contender>& contenders) {
  double fastest = std::numeric_limits<double>::infinity();
  for (const Contender& contender : contenders) {
    if (contender.result.method == method)
      fastest = std::min(fastest, median(contender.result.us_per_round));
  }
  return fastest;
}

/// Drops settings that took more than `times` the time of the fastest setting of their method.
/// Forgets all times.
void keepFastest(double times, std::vector<Contender>& contenders) {
  std::vector<double> limits;
  for (const Contender& contender : contenders)
    limits.push_back(times * fastestOf(contender.result.method, contenders));
  std::vector<Contender> kept;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    if (median(contenders[i].result.us_per_round) <= limits[i])
      kept.push_back(std::move(contenders[i]));
  }
  contenders = std::move(kept);
  for (Contender& contender : contenders)
    contender.result.us_per_round.clear();
}

}  // namespace

OverlapResults measureOverlaps(const std::vector<OverlapSetting>& settings, OverlapScene scene,
                               int rounds) {
  SceneBoxes boxes;
  scene.advance(boxes);
  std::vector<Contender> contenders;
  for (const OverlapSetting& setting : settings)
    contenders.push_back(makeContender(setting, scene.name, boxes));
  std::mt19937 engine(3);
  Round round(kStepsPerRound);
  for (int i = 0; i < kChoiceRounds + rounds; ++i) {
    if (i == kFirstRounds || i == kTrialRounds) keepFastest(kHopeless, contenders);
    if (i == kChoiceRounds) keepFastest(1, contenders);
    for (SceneBoxes& step : round)
      scene.advance(step);
    runAll(round, contenders, engine);
  }
  OverlapResults results;
  for (Contender& contender : contenders)
    results.push_back(std::move(contender.result));
  return results;
}

}  // namespace link_bounds::bench

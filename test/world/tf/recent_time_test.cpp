// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Beside all observations, of a clock that jumps and of one that is observed irregularly.
#include "world/tf/recent_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace link_bounds {
namespace {

class RecentTimes : public testing::TestWithParam<int> {};

TEST_P(RecentTimes, AreThoseOfOneMomentAgoToTwo) {
  constexpr double kMoment = 0.1, kRounding = 1e-6;
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const auto chance = [&] { return std::uniform_real_distribution<>(0, 1)(random); };
  RecentTime recent;
  recent.setMoment(ros::WallDuration(kMoment));
  std::vector<std::pair<double, ros::Time>> observations;  // of one era, by steady time
  double steady = 1000, now = 50;
  for (int i = 0; i < 2000; ++i) {
    const double step = chance() < 0.05 ? 3 * kMoment * chance() : 0.02 * chance();
    steady += step;
    now += chance() < 0.02 ? 100 * chance() : step;
    if (chance() < 0.01) {
      for (const auto& [time, value] : observations)
        now = std::min(now, value.toSec());
      now *= chance();
      observations.clear();
    }
    recent.observe(ros::Time(now), ros::SteadyTime(steady));
    observations.emplace_back(steady, ros::Time(now));
    // Whoever was heard within the last moment was heard then or later; nobody who was silent for
    // two moments was.
    for (const auto& [time, value] : observations) {
      if (steady - time < kMoment - kRounding) {
        ASSERT_LE(recent.since(), value) << "step " << i;
      }
    }
    const auto oldest = std::find_if(
        observations.begin(), observations.end(),
        [&](const auto& each) { return steady - each.first <= 2 * kMoment + kRounding; });
    ASSERT_GE(recent.since(), oldest->second) << "step " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RecentTimes, testing::Range(1, 21));

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Quantiles beside those of a sorted list.
#include "node/diagnostics/duration_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace link_bounds {
namespace {

constexpr double kClassWidth = 0.25;  // of where a class begins

TEST(DurationHistogram, NothingTookNoTime) {
  EXPECT_EQ(DurationHistogram().quantile(0.99), 0);
  EXPECT_EQ(DurationHistogram().longest(), 0);
}

TEST(DurationHistogram, QuantilesAreNeverTooShortAndHardlyTooLong) {
  std::mt19937 random(1);
  std::lognormal_distribution<double> distribution(-1, 1);  // ms
  DurationHistogram histogram;
  std::vector<double> durations(10000);
  for (double& duration : durations) {
    duration = distribution(random);
    histogram.add(duration);
  }
  std::sort(durations.begin(), durations.end());
  for (const double part : {0.001, 0.1, 0.5, 0.9, 0.99, 1.0}) {
    const double truth = durations[static_cast<std::size_t>(part * 10000) - 1];
    EXPECT_GE(histogram.quantile(part), truth) << part;
    EXPECT_LE(histogram.quantile(part), truth * (1 + kClassWidth)) << part;
  }
  EXPECT_EQ(histogram.longest(), durations.back());
  EXPECT_EQ(histogram.count(), durations.size());
}

TEST(DurationHistogram, WhatIsOutOfItsRangeCountsAtTheEnds) {
  DurationHistogram histogram;
  histogram.add(0);
  histogram.add(1e-6);
  histogram.add(1e9);
  EXPECT_EQ(histogram.count(), 3u);
  EXPECT_LE(histogram.quantile(0.5), 1e-3 * (1 + kClassWidth));
  EXPECT_EQ(histogram.quantile(1.0), 1e9);
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Searching boxes that keep moving allocates nothing.
#include <gtest/gtest.h>

#include "link_bounds/geometry/pairs/sweep_and_prune.h"
#include "testing/brute_force.h"
#include "testing/replaced_new.h"

namespace link_bounds {
namespace {

constexpr int kPeriod = 50;

/// Boxes that swing in different directions. Steps are smaller or larger than the slack.
std::vector<Aabb> swinging(int step, double amplitude) {
  brute_force::Random random(1);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d center = random.vector(0.7);
    const Eigen::Vector3d swing = random.vector(amplitude);
    const Eigen::Vector3d min = center + std::sin(2 * M_PI * step / kPeriod) * swing;
    boxes.emplace_back(min, min + Eigen::Vector3d::Constant(0.2));
  }
  return boxes;
}

TEST(SweepAndPruneMemory, SteadyMotionAllocatesNothing) {
  for (const double amplitude : {0.01, 0.1, 1.0}) {
    std::vector<std::vector<Aabb>> steps;
    for (int i = 0; i < kPeriod; ++i)
      steps.push_back(swinging(i, amplitude));
    SweepAndPrune search;
    std::size_t found = 0;
    const auto run = [&](int periods) {
      for (int i = 0; i < periods * kPeriod; ++i)
        found += search.find(steps[static_cast<std::size_t>(i % kPeriod)], 0.01).size();
    };
    run(4);
    long allocations = 0;
    replaced_new::counter = &allocations;
    run(10);
    replaced_new::counter = nullptr;
    EXPECT_EQ(allocations, 0) << "with amplitude " << amplitude;
    EXPECT_GT(found, 0u);
  }
}

/// Wherever memory runs out in a search, the next one finds all pairs.
TEST(SweepAndPruneMemory, ASearchThatFailsLeavesNothing) {
  constexpr double kMargin = 1;  // so that the pairs take more memory than the boxes
  const std::vector<Aabb> boxes = swinging(1, 0.1);
  const std::vector<BoxPair> expected = SweepAndPrune().find(boxes, kMargin);
  int failures = 0;
  for (std::size_t limit = 8; limit < 400000; limit += 2000) {
    SweepAndPrune search;
    replaced_new::limit = limit;
    try {
      search.find(boxes, kMargin);
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    replaced_new::limit = replaced_new::kNoLimit;
    const std::vector<BoxPair>& found = search.find(boxes, kMargin);
    ASSERT_EQ(found.size(), expected.size()) << "limit " << limit;
  }
  EXPECT_GT(failures, 0);
}

}  // namespace
}  // namespace link_bounds

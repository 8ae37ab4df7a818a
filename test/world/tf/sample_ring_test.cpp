// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The ring beside std::map: in order, nothing lost that is in reach, no more memory than that
// needs.
#include "world/tf/sample_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace link_bounds {
namespace {

constexpr std::int64_t kReach = 1000;

/// The same samples twice. A sample's parent tells which one it is.
class Both {
 public:
  void add(std::int64_t stamp, std::size_t parent) {
    const std::int64_t newest = map_.empty() ? stamp : map_.rbegin()->first;
    EdgeSample& sample = map_.empty() || stamp > newest ? ring_.push(newest - kReach)
                                                        : ring_.insert(stamp, newest - kReach);
    sample.stamp = stamp;
    sample.parent = parent;
    map_[stamp] = parent;
    map_.erase(map_.begin(), map_.lower_bound(map_.rbegin()->first - kReach));
  }

  bool has(std::int64_t stamp) const { return map_.count(stamp) > 0; }
  std::int64_t newest() const { return map_.rbegin()->first; }
  std::int64_t oldest() const { return map_.begin()->first; }
  std::size_t size() const { return map_.size(); }
  const SampleRing& ring() const { return ring_; }

  void expectSame(std::int64_t stamp) const {
    EXPECT_EQ(ring_.newest().stamp, newest());
    EXPECT_EQ(ring_.newest().parent, map_.rbegin()->second);
    const auto later = map_.upper_bound(stamp);
    const auto [older, newer] = ring_.neighbours(stamp);
    ASSERT_TRUE(older && newer);
    EXPECT_EQ(newer->stamp, later->first);
    EXPECT_EQ(newer->parent, later->second);
    EXPECT_EQ(older->stamp, std::prev(later)->first);
    EXPECT_EQ(older->parent, std::prev(later)->second);
  }

 private:
  SampleRing ring_;
  std::map<std::int64_t, std::size_t> map_;
};

TEST(SampleRing, IsAnOrderedMapWithinReach) {
  std::mt19937 random(1);
  const auto pick = [&random](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  Both both;
  both.add(0, 0);
  for (std::size_t i = 1; i < 20000; ++i) {
    const bool is_late = pick(0, 3) == 0;
    const std::int64_t newest = both.newest();
    const std::int64_t stamp = is_late ? newest - pick(0, kReach) : newest + pick(1, 20);
    if (!both.has(stamp)) both.add(stamp, i);
    if (both.size() > 1) both.expectSame(pick(both.oldest(), both.newest() - 1));
  }
}

TEST(SampleRing, KnowsWhatItDoesNotReach) {
  Both both;
  both.add(10, 1);
  both.add(20, 2);
  EXPECT_EQ(both.ring().neighbours(9).older, nullptr);
  EXPECT_EQ(both.ring().neighbours(9).newer->stamp, 10);
}

/// Samples that come as a clock ticks, not quite regularly.
std::size_t capacityAfter(Both& both, int samples, std::int64_t period) {
  std::size_t largest = 0;
  for (int i = 0; i < samples; ++i) {
    both.add(both.newest() + period - i % 2, 0);
    largest = std::max(largest, both.ring().capacity());
  }
  return largest;
}

TEST(SampleRing, TakesAndKeepsOnlyTheMemoryThatItsReachNeeds) {
  Both both;
  both.add(0, 0);
  const std::size_t full = capacityAfter(both, 2000, 2);
  EXPECT_GE(full, both.size());
  EXPECT_LE(full, both.size() + 30);
  EXPECT_EQ(capacityAfter(both, 20000, 2), full) << "a steady edge needs no more";
  capacityAfter(both, 20000, 50);
  EXPECT_LE(both.ring().capacity(), both.size() + 30) << "a slower edge gives memory back";
}

TEST(SampleRing, BeginsAnewAfterClear) {
  SampleRing ring;
  ring.push(0).stamp = 5;
  ring.clear();
  EXPECT_TRUE(ring.isEmpty());
  EXPECT_EQ(ring.capacity(), 0u);
  ring.push(0).stamp = 3;
  EXPECT_EQ(ring.newest().stamp, 3);
}

}  // namespace
}  // namespace link_bounds

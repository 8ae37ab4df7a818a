// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One edge beside tf2's own cache.
#include "node/tf/edge_history.h"

#include <gtest/gtest.h>
#include <tf2/time_cache.h>

#include <cmath>
#include <iostream>
#include <limits>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSame = 1e-12;            // m, and of the numbers of a quaternion
constexpr std::int64_t kStep = 500000000;  // ns; so coarse that many stamps are the oldest one
constexpr int kHistories = 200;
constexpr int kSamples = 200;

/// The same number, or both NaN.
bool isSame(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || a == b || std::abs(a - b) < kSame;
}

class BesideTimeCache {
 public:
  explicit BesideTimeCache(std::uint64_t seed) : random_(seed) {}

  /// Mostly new, sometimes late or far too late; some are infinite, some have another parent.
  void insertOne() {
    newest_ += pick(3) * kStep;
    const std::int64_t stamp = newest_ - (pick(3) == 0 ? pick(26) * kStep : 0);
    const Tf2Pose pose(tf2::Quaternion({0, 0, 1}, random_.uniform(-3, 3)),
                       {pick(4) == 0 ? kInfinity : random_.uniform(-1, 1), 1, 2});
    const unsigned parent = pick(10) == 0 ? 2 : 1;
    tf2::TransformStorage storage;
    storage.stamp_ = time(stamp);
    storage.frame_id_ = parent;
    storage.rotation_ = pose.rotation();
    storage.translation_ = pose.translation();
    EXPECT_EQ(ours_.insert(stamp, parent, pose), theirs_.insertData(storage)) << stamp;
  }

  /// At every step of the last twelve seconds, and between; returns how many were known.
  int expectSame() {
    int known = 0;
    for (int i = 0; i < 48; ++i)
      known += expectSame(newest_ - i * kStep / 2);
    return known;
  }

 private:
  static ros::Time time(std::int64_t stamp) {
    return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp));
  }

  bool expectSame(std::int64_t stamp) {
    EdgeSample scratch;
    const EdgeSample* sample = ours_.at(stamp, scratch);
    tf2::TransformStorage expected;
    const bool is_known = theirs_.getData(time(stamp), expected);
    EXPECT_EQ(sample != nullptr, is_known) << newest_ - stamp;
    if (!sample || !is_known) return false;
    EXPECT_EQ(sample->parent, expected.frame_id_) << newest_ - stamp;
    const tf2::Vector3 t = sample->parent_from_child.translation();
    const tf2::Quaternion q = sample->parent_from_child.rotation();
    EXPECT_TRUE(isSame(t.x(), expected.translation_.x()))
        << "x " << t.x() << ", not " << expected.translation_.x() << ", "
        << static_cast<double>(newest_ - stamp) / 1e9 << " s before the newest";
    EXPECT_TRUE(isSame(q.z(), expected.rotation_.z()) && isSame(q.w(), expected.rotation_.w()));
    return true;
  }

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  brute_force::Random random_;
  EdgeHistory ours_{false};
  tf2::TimeCache theirs_;
  std::int64_t newest_ = 1700000000000000000;
};

TEST(EdgeHistory, IsTf2sTimeCacheAtEveryStamp) {
  long known = 0;
  for (std::uint64_t seed = 1; seed <= kHistories && !HasFailure(); ++seed) {
    BesideTimeCache both(seed);
    for (int i = 0; i < kSamples && !HasFailure(); ++i) {
      both.insertOne();
      known += both.expectSame();
    }
  }
  std::cout << known << " poses were known\n";
  EXPECT_GT(known, 10L * kHistories * kSamples);
}

}  // namespace
}  // namespace link_bounds

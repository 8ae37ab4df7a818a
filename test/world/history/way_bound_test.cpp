// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random transforms, also late ones and other parents, between bounds of ways: what is remembered
// of an edge is what a look without memory finds.
#include "world/history/way_bound.h"

#include <gtest/gtest.h>

#include <random>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

constexpr int kSteps = 3000;
constexpr std::int64_t kSecond = 1'000'000'000;

class WayBoundRandom : public testing::Test {
 protected:
  double draw(double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random_);
  }
  int below(int count) { return static_cast<int>(draw(0, count)); }

  /// Most come in order.
  void addTransform() {
    const std::string child = below(2) == 0 ? "arm" : "hand";
    const std::string usual = child == "arm" ? "base" : "arm";
    if (below(3) > 0) now_ += draw(0.01, 0.2);
    const double stamp = below(5) == 0 ? draw(std::max(now_ - 3, 1.0), now_) : now_;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(draw(-1, 1), Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d place(draw(-1, 1), draw(-1, 1), draw(-1, 1));
    tf_.add({edge(below(40) == 0 ? "cart" : usual, child, stamp, turn, place)}, false,
            ros::Time(now_));
  }

  /// Spans often come again.
  MotionSpan span() {
    if (below(3) > 0) return span_;
    const double begin = draw(std::max(now_ - 2, 1.0), now_);
    span_ = {static_cast<std::int64_t>(begin * kSecond),
             static_cast<std::int64_t>((begin + draw(0, 1)) * kSecond)};
    return span_;
  }

  void compare() {
    const MotionSpan now = span();
    EdgeWays fresh_edges(tf_);
    WayBound fresh(fresh_edges, target_.frame());
    for (const TransformBuffer::Hold* frame : {&arm_, &hand_}) {
      const double way = ways_.of(frame->frame(), 0.5, now);
      EXPECT_EQ(way, fresh.of(frame->frame(), 0.5, now));
      known_ += std::isfinite(way) ? 1 : 0;
    }
  }

  std::mt19937 random_{1};
  double now_ = 10;
  MotionSpan span_{9 * kSecond, 10 * kSecond};
  TransformBuffer tf_;
  TransformBuffer::Hold target_{tf_, "base"}, arm_{tf_, "arm"}, hand_{tf_, "hand"};
  EdgeWays edges_{tf_};
  WayBound ways_{edges_, target_.frame()};
  int known_ = 0;
};

TEST_F(WayBoundRandom, IsThatOfALookWithoutMemory) {
  for (int step = 0; step < kSteps && !HasFailure(); ++step) {
    SCOPED_TRACE(step);
    if (below(500) == 0) tf_.clear();
    if (below(2) == 0) addTransform();
    compare();
  }
  EXPECT_GT(known_, kSteps / 2);
}

}  // namespace
}  // namespace link_bounds

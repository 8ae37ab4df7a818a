// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A loss is reported once, after five seconds, and again only after it was right in between.
#include "node/log/loss_log.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

using Names = std::vector<std::string>;

class LossLogTest : public testing::Test {
 protected:
  Names due(const Names& lost, double time) {
    Names result;
    for (const std::size_t i : log_.due(lost, ros::SteadyTime(1000 + time)))
      result.push_back(lost[i]);
    return result;
  }

  LossLog log_;
};

TEST_F(LossLogTest, ReportsOnceAfterFiveSeconds) {
  for (double time = 0; time < 5; time += 0.5)
    EXPECT_EQ(due({"arm"}, time), Names());
  EXPECT_EQ(due({"arm"}, 5), Names{"arm"});
  for (double time = 5.5; time < 100; time += 0.5)
    EXPECT_EQ(due({"arm"}, time), Names());
}

TEST_F(LossLogTest, ReportsAgainAfterItWasRight) {
  due({"arm"}, 0);
  EXPECT_EQ(due({"arm"}, 5), Names{"arm"});
  due({}, 6);
  EXPECT_EQ(due({"arm"}, 7), Names());
  EXPECT_EQ(due({"arm"}, 11.5), Names());
  EXPECT_EQ(due({"arm"}, 12), Names{"arm"});
}

TEST_F(LossLogTest, ShortLossesAreNotReported) {
  for (double time = 0; time < 100; time += 4) {
    EXPECT_EQ(due({"arm"}, time), Names());
    EXPECT_EQ(due({"arm"}, time + 3), Names());
    EXPECT_EQ(due({}, time + 3.5), Names());
  }
}

TEST_F(LossLogTest, SeveralAreReportedTogetherInTheirOrder) {
  due({"leg", "arm"}, 0);
  due({"leg", "hand", "arm"}, 1);
  EXPECT_EQ(due({"leg", "hand", "arm"}, 5), (Names{"leg", "arm"}));
  EXPECT_EQ(due({"leg", "hand", "arm"}, 6), Names()) << "two reports within five seconds";
  EXPECT_EQ(due({"leg", "hand", "arm"}, 10), Names{"hand"});
}

TEST_F(LossLogTest, NamesWithoutEndDoNotFloodTheLog) {
  Names lost;
  std::size_t reports = 0;
  for (int i = 0; i < 200; ++i) {
    lost.push_back("frame_" + std::to_string(i));
    reports += due(lost, 0.5 * i).empty() ? 0 : 1;
  }
  EXPECT_EQ(reports, 19u);  // in 100 s
}

TEST_F(LossLogTest, APostponedLossBeginsAgain) {
  due({"arm"}, 0);
  log_.postpone({"arm"}, ros::SteadyTime(1004));
  EXPECT_EQ(due({"arm"}, 8), Names());
  EXPECT_EQ(due({"arm"}, 9), Names{"arm"});
  log_.postpone({"arm"}, ros::SteadyTime(1010));
  EXPECT_EQ(due({"arm"}, 20), Names()) << "it was not right in between";
  log_.postpone({}, ros::SteadyTime(1021));
  due({"arm"}, 22);
  EXPECT_EQ(due({"arm"}, 27), Names{"arm"});
}

}  // namespace
}  // namespace link_bounds

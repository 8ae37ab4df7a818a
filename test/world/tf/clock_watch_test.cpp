// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What counts as a jump of the clock.
#include "world/tf/clock_watch.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

using Event = ClockWatch::Event;

const ros::SteadyTime kStart(1000);

TEST(ClockWatch, TellsStartAndJumps) {
  ClockWatch clock;
  EXPECT_EQ(clock.observe(ros::Time(0)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(100)), Event::kStarted);
  EXPECT_EQ(clock.observe(ros::Time(100.5)), Event::kNone);
  EXPECT_FALSE(clock.hasJustJumped());
  EXPECT_EQ(clock.observe(ros::Time(95)), Event::kJumpedBack);
  EXPECT_TRUE(clock.hasJustJumped());
  EXPECT_EQ(clock.observe(ros::Time(95.5)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(97.5)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(99.6)), Event::kJumpedAhead);
}

TEST(ClockWatch, SmallStepsBackAreNoJumpUntilTheyAddUp) {
  ClockWatch clock;
  clock.observe(ros::Time(100));
  EXPECT_EQ(clock.observe(ros::Time(99.95)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(99.91)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(99.85)), Event::kJumpedBack);
}

TEST(ClockWatch, DoubtsStampsAheadOnlyAfterAJump) {
  ClockWatch clock([] { return kStart; });
  clock.observe(ros::Time(100));
  EXPECT_FALSE(clock.isFromBeforeJump(ros::Time(103), ros::Time(100), kStart));
  clock.observe(ros::Time(90));
  EXPECT_TRUE(clock.isFromBeforeJump(ros::Time(99), ros::Time(90), kStart));
  EXPECT_FALSE(clock.isFromBeforeJump(ros::Time(90.4), ros::Time(90), kStart));
}

TEST(ClockWatch, AMessageIsOldHoweverLongItWaitsAfterTheJump) {
  ros::SteadyTime now = kStart;
  ClockWatch clock([&now] { return now; });
  clock.observe(ros::Time(100));
  const ros::SteadyTime before = now;
  now += ros::WallDuration(3);
  clock.observe(ros::Time(90));
  const ros::SteadyTime jump = now;
  now += ros::WallDuration(100);
  clock.observe(ros::Time(92));
  EXPECT_TRUE(clock.isFromBeforeJump(ros::Time(97.27), ros::Time(92), before));
  EXPECT_TRUE(
      clock.isFromBeforeJump(ros::Time(97.27), ros::Time(92), jump + ros::WallDuration(0.49)));
  EXPECT_FALSE(
      clock.isFromBeforeJump(ros::Time(97.27), ros::Time(92), jump + ros::WallDuration(0.51)));
}

TEST(ClockWatch, TheEndsOfTimeAreTimesLikeOthers) {
  ClockWatch clock([] { return kStart; });
  EXPECT_EQ(clock.observe(ros::Time(1)), Event::kStarted);
  EXPECT_EQ(clock.observe(ros::TIME_MAX), Event::kJumpedAhead);
  EXPECT_FALSE(clock.isFromBeforeJump(ros::TIME_MAX, ros::TIME_MAX, kStart));
  EXPECT_EQ(clock.observe(ros::Time(1)), Event::kJumpedBack);
  EXPECT_TRUE(clock.isFromBeforeJump(ros::TIME_MAX, ros::Time(1), kStart));
}

}  // namespace
}  // namespace link_bounds

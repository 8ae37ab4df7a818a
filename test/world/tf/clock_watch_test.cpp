// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What counts as a jump of the clock.
#include "world/tf/clock_watch.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

using Event = ClockWatch::Event;

TEST(ClockWatch, TellsStartAndJumps) {
  ClockWatch clock;
  EXPECT_EQ(clock.observe(ros::Time(0)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(100)), Event::kStarted);
  EXPECT_EQ(clock.observe(ros::Time(101)), Event::kNone);
  EXPECT_FALSE(clock.hasJustJumped());
  EXPECT_EQ(clock.observe(ros::Time(95)), Event::kJumpedBack);
  EXPECT_TRUE(clock.hasJustJumped());
  EXPECT_EQ(clock.observe(ros::Time(95.5)), Event::kNone);
}

TEST(ClockWatch, SmallStepsBackAreNoJumpUntilTheyAddUp) {
  ClockWatch clock;
  clock.observe(ros::Time(100));
  EXPECT_EQ(clock.observe(ros::Time(99.95)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(99.91)), Event::kNone);
  EXPECT_EQ(clock.observe(ros::Time(99.85)), Event::kJumpedBack);
}

TEST(ClockWatch, DoubtsStampsAheadOnlyAfterAJump) {
  ClockWatch clock;
  clock.observe(ros::Time(100));
  EXPECT_FALSE(clock.isFromBeforeJump(ros::Time(103), ros::Time(100)));
  clock.observe(ros::Time(90));
  EXPECT_TRUE(clock.isFromBeforeJump(ros::Time(99), ros::Time(90)));
  EXPECT_FALSE(clock.isFromBeforeJump(ros::Time(90.4), ros::Time(90)));
}

TEST(ClockWatch, TheEndsOfTimeAreTimesLikeOthers) {
  ClockWatch clock;
  EXPECT_EQ(clock.observe(ros::Time(1)), Event::kStarted);
  EXPECT_EQ(clock.observe(ros::TIME_MAX), Event::kNone);
  EXPECT_FALSE(clock.isFromBeforeJump(ros::TIME_MAX, ros::TIME_MAX));
  EXPECT_EQ(clock.observe(ros::Time(1)), Event::kJumpedBack);
  EXPECT_TRUE(clock.isFromBeforeJump(ros::TIME_MAX, ros::Time(1)));
}

}  // namespace
}  // namespace link_bounds

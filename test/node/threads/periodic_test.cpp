// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that are due are called, others are not; how long a thread may wait.
#include "node/threads/periodic.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

const ros::WallDuration kHour(3600);

TEST(Periodic, CallsWhatIsDueAgainAndAgain) {
  Periodic periodic;
  int due = 0, waiting = 0;
  periodic.add(ros::WallDuration(0), [&] { ++due; });
  periodic.add(kHour, [&] { ++waiting; });
  periodic.callDue();
  periodic.callDue();
  EXPECT_EQ(due, 2);
  EXPECT_EQ(waiting, 0);
}

TEST(Periodic, WhatTakesLongerThanItsPeriodIsNotAlwaysDue) {
  Periodic periodic;
  int calls = 0;
  periodic.add(kHour, [] {});
  periodic.add(ros::WallDuration(0.1), [&] {
    ++calls;
    const ros::SteadyTime begin = ros::SteadyTime::now();
    while (ros::SteadyTime::now() - begin < ros::WallDuration(0.2)) {
    }
  });
  while (calls == 0)
    periodic.callDue();
  EXPECT_GT(periodic.rest(), std::chrono::nanoseconds(0));
}

TEST(Periodic, RestIsUntilTheFirstThatIsDue) {
  Periodic periodic;
  EXPECT_EQ(periodic.rest(), std::chrono::hours(24));
  periodic.add(kHour, [] {});
  EXPECT_LE(periodic.rest(), std::chrono::hours(1));
  EXPECT_GT(periodic.rest(), std::chrono::nanoseconds(0));
  periodic.add(ros::WallDuration(0), [] {});
  EXPECT_EQ(periodic.rest(), std::chrono::nanoseconds(0));
}

TEST(Periodic, CallsAnAlarmOnceForEachTimeThatIsSet) {
  Periodic periodic;
  int calls = 0;
  Periodic::Alarm again = 0;
  const Periodic::Alarm alarm = periodic.addAlarm([&] { ++calls; });
  again = periodic.addAlarm([&] { periodic.setAlarm(alarm, ros::SteadyTime::now()); });
  EXPECT_EQ(periodic.rest(), std::chrono::hours(24));
  periodic.callDue();
  EXPECT_EQ(calls, 0);
  periodic.setAlarm(alarm, ros::SteadyTime::now());
  EXPECT_EQ(periodic.rest(), std::chrono::nanoseconds(0));
  for (int i = 0; i < 3; ++i)
    periodic.callDue();
  EXPECT_EQ(calls, 1);
  periodic.setAlarm(alarm, ros::SteadyTime::now() + kHour);
  EXPECT_GT(periodic.rest(), std::chrono::minutes(50));
  periodic.callDue();
  periodic.setAlarm(alarm, ros::SteadyTime::now());
  periodic.setAlarm(alarm, std::nullopt);
  periodic.callDue();
  EXPECT_EQ(calls, 1);
  periodic.setAlarm(again, ros::SteadyTime::now());
  for (int i = 0; i < 2; ++i)
    periodic.callDue();
  EXPECT_EQ(calls, 2) << "the functions may set alarms";
}

}  // namespace
}  // namespace link_bounds

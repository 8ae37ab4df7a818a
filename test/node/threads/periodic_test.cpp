// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that are due are called, others are not; how long a thread may wait.
#include "node/threads/periodic.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

const ros::WallDuration kHour(3600);
const ros::WallDuration kDay(24 * 3600);

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

TEST(Periodic, RestIsUntilTheFirstThatIsDue) {
  Periodic periodic;
  EXPECT_EQ(periodic.rest(kDay), kDay);
  periodic.add(kHour, [] {});
  const ros::WallDuration rest = periodic.rest(kDay);
  EXPECT_LE(rest, kHour);
  EXPECT_GT(rest, ros::WallDuration(0));
  EXPECT_EQ(periodic.rest(ros::WallDuration(0)), ros::WallDuration(0));
  periodic.add(ros::WallDuration(0), [] {});
  EXPECT_EQ(periodic.rest(kDay), ros::WallDuration(0));
}

}  // namespace
}  // namespace link_bounds

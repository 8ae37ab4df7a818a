// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/outputs/topic/paced_output.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

namespace link_bounds {
namespace {

using std::chrono::minutes;

constexpr double kPerHour = 1.0 / 3600;  // Hz

/// Requests that lead to nothing but a count.
struct Paced {
  explicit Paced(double patience)
      : output(
            periodic,
            [this](const auto& call) {
              before_alarm();
              call();
            },
            [this] { ++calls; }, patience) {}

  Periodic periodic;
  std::function<void()> before_alarm = [] {};
  int calls = 0;
  PacedOutput output;
};

TEST(PacedOutput, CallsAtOnceThenWhenThePeriodIsOver) {
  Paced paced(0);
  paced.output.setRate(kPerHour);
  for (int i = 0; i < 3; ++i)
    paced.output.request();
  EXPECT_EQ(paced.calls, 1);
  EXPECT_GT(paced.periodic.rest(), minutes(59));
  EXPECT_LE(paced.periodic.rest(), minutes(60));
  paced.output.emitNow();
  EXPECT_EQ(paced.calls, 2);
  EXPECT_GT(paced.periodic.rest(), minutes(61)) << "nothing waits any more";
}

TEST(PacedOutput, WithPatienceWaitsLonger) {
  Paced paced(0.25);
  paced.output.setRate(kPerHour);
  for (int i = 0; i < 3; ++i)
    paced.output.request();
  EXPECT_EQ(paced.calls, 1);
  EXPECT_GT(paced.periodic.rest(), minutes(74));
  EXPECT_LE(paced.periodic.rest(), minutes(75));
  paced.output.setRate(2 * kPerHour);
  EXPECT_GT(paced.periodic.rest(), minutes(37));
  EXPECT_LE(paced.periodic.rest(), minutes(38));
}

/// The alarm is hours away: only a request can have led to the call.
TEST(PacedOutput, WithPatienceCallsForTheFirstRequestAfterThePeriod) {
  constexpr double kRate = 100;  // Hz
  Paced paced(1e6);
  paced.output.setRate(kRate);
  paced.output.request();
  const auto first = ros::SteadyTime::now();
  while (paced.calls < 2) {
    paced.output.request();
    ASSERT_LT(ros::SteadyTime::now() - first, ros::WallDuration(30));
    paced.periodic.callDue();
  }
  EXPECT_GT(ros::SteadyTime::now() - first, ros::WallDuration(0.99 / kRate));
}

/// The node's guard updates the scene before an alarm, which requests an output of what is new.
TEST(PacedOutput, ARequestBeforeTheAlarmIsAnsweredOnce) {
  Paced paced(0);
  paced.output.setRate(100);
  int alarms = 0;
  paced.before_alarm = [&] {
    ++alarms;
    paced.output.request();
  };
  paced.output.request();
  paced.output.request();
  const auto start = ros::SteadyTime::now();
  while (alarms == 0) {
    paced.periodic.callDue();
    ASSERT_LT(ros::SteadyTime::now() - start, ros::WallDuration(30));
  }
  EXPECT_EQ(paced.calls, 2);
}

}  // namespace
}  // namespace link_bounds

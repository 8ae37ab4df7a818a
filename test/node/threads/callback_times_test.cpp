// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is recorded of callbacks that wait, work, or throw.
#include "node/threads/callback_times.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "testing/patience.h"

namespace link_bounds {
namespace {

constexpr double kWait = 20;  // ms

void wait() {
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kWait));
}

TEST(Durations, HaveCountMeanAndMaximum) {
  Durations durations;
  for (const double duration : {1.0, 6.0, 2.0})
    durations.add(duration);
  EXPECT_EQ(durations.count, 3u);
  EXPECT_EQ(durations.mean(), 3);
  EXPECT_EQ(durations.max, 6);
}

TEST(CallbackTimes, WaitingTakesWallTimeButNoCpuTime) {
  CallbackTimes times;
  times.measure(wait);
  times.measure([] {});
  EXPECT_GE(times.longest(), kWait);
  EXPECT_LT(times.longestCpu(), kWait / 2);
  EXPECT_EQ(times.tf().count, 0u);
}

TEST(CallbackTimes, RecentTfMessagesAreThoseSinceTheyWereTaken) {
  CallbackTimes times;
  times.measureTf(wait);
  EXPECT_EQ(times.takeRecentTf().count, 1u);
  EXPECT_EQ(times.takeRecentTf().count, 0u);
  times.measureTf([] {});
  EXPECT_EQ(times.tf().count, 2u);
  EXPECT_EQ(times.takeRecentTf().count, 1u);
  // What does nothing may also take long, where the machine is busy, but not each time.
  EXPECT_TRUE(becomesTrue([&] {
    times.measureTf([] {});
    times.measureTf([] {});
    const Durations recent = times.takeRecentTf();
    EXPECT_EQ(recent.count, 2u);
    EXPECT_LE(recent.mean(), recent.max);
    return recent.max < kWait;
  }));
  EXPECT_GE(times.tf().max, kWait);
  EXPECT_EQ(times.longest(), times.tf().max);
}

TEST(CallbackTimes, ACallbackThatThrowsIsMeasuredToo) {
  CallbackTimes times;
  const auto fail = [] {
    wait();
    throw std::runtime_error("failed");
  };
  EXPECT_THROW(times.measure(fail), std::runtime_error);
  EXPECT_GE(times.longest(), kWait);
}

}  // namespace
}  // namespace link_bounds

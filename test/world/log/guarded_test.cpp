// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a callback throws is logged, throttled, also while there is no /clock.
#include "world/log/guarded.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include <stdexcept>

namespace link_bounds {
namespace {

TEST(Guarded, LogsOneExceptionPerSecondWhileRosTimeIsZero) {
  ros::Time::setNow(ros::Time(0));
  testing::internal::CaptureStderr();
  for (int i = 0; i < 100; ++i)
    guarded([] { throw std::runtime_error("no\nmemory"); });
  const std::string log = testing::internal::GetCapturedStderr();
  const std::string line = "unexpected: no?memory";
  EXPECT_NE(log.find(line), std::string::npos) << log;
  EXPECT_EQ(log.find(line), log.rfind(line)) << log;
}

}  // namespace
}  // namespace link_bounds

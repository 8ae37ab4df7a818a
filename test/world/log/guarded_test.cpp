// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a callback throws is logged, throttled, also while there is no /clock.
#include "world/log/guarded.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include <cstdlib>
#include <new>
#include <stdexcept>

namespace link_bounds {
namespace {

TEST(Guarded, LogsOneExceptionPerSecondWhileRosTimeIsZero) {
  ros::Time::setNow(ros::Time(0));
  testing::internal::CaptureStderr();
  const std::uint64_t before = unexpectedErrors();
  for (int i = 0; i < 100; ++i)
    guarded([] { throw std::runtime_error("no\nmemory"); });
  EXPECT_EQ(unexpectedErrors(), before + 100);
  const std::string log = testing::internal::GetCapturedStderr();
  const std::string line = "unexpected: no?memory";
  EXPECT_NE(log.find(line), std::string::npos) << log;
  EXPECT_EQ(log.find(line), log.rfind(line)) << log;
}

TEST(Completed, EndsTheProcessWhereMemoryRunsOut) {
  const auto run = [](bool has_memory) {
    guarded([&] {
      completed([&] {
        if (!has_memory) throw std::bad_alloc();
      });
    });
    std::exit(0);
  };
  EXPECT_EXIT(run(true), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(run(false), testing::ExitedWithCode(1), "memory ran out during an update");
}

TEST(Completed, PassesOnOtherExceptions) {
  EXPECT_THROW(completed([] { throw std::runtime_error("no"); }), std::runtime_error);
}

}  // namespace
}  // namespace link_bounds

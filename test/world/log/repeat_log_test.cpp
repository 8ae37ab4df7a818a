// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What happens again and again is one line in ten seconds.
#include "world/log/repeat_log.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

TEST(RepeatLog, OneLineInTenSecondsCountsAll) {
  RepeatLog log;
  const auto line = [&log](double time) { return log.line("it broke", ros::SteadyTime(time)); };
  EXPECT_EQ(line(100), "it broke");
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(line(100 + 0.009 * i), "");
  EXPECT_EQ(line(111), "it broke (1001 times)");
  EXPECT_EQ(line(130), "it broke");
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Refused transforms are reported, but throttled.
#include "world/log/refusal_log.h"

#include <gtest/gtest.h>

#include <deque>
#include <string>

namespace link_bounds {
namespace {

class RefusalLogTest : public testing::Test {
 protected:
  std::optional<std::string> line(const std::string& frame, double time) {
    return log_.line(frame, "it is bad; mend it", "/driver", ros::SteadyTime(1000 + time));
  }

  RefusalLog log_{"a transform of", "transforms of further frames"};
};

TEST_F(RefusalLogTest, NamesFramePublisherAndRemedy) {
  EXPECT_EQ(line("arm", 0),
            "a transform of \"arm\" from \"/driver\" is refused: it is bad; mend it");
}

TEST_F(RefusalLogTest, ReportsAFrameOnceInTenSeconds) {
  EXPECT_TRUE(line("arm", 0));
  EXPECT_FALSE(line("arm", 9));
  EXPECT_TRUE(line("leg", 9));
  EXPECT_TRUE(line("arm", 11));
  EXPECT_FALSE(line("leg", 18)) << "arm began a period of its own";
  EXPECT_TRUE(line("leg", 19));
}

TEST_F(RefusalLogTest, AnyTenSecondsHaveAtMostElevenLines) {
  std::deque<double> lines;  // their times in the last ten seconds
  for (int i = 0; i < 20000; ++i) {
    const double time = i * 0.01;
    if (line("frame_" + std::to_string(i % 97), time)) lines.push_back(time);
    while (!lines.empty() && time - lines.front() > 10 - 1e-6)
      lines.pop_front();
    ASSERT_LE(lines.size(), 11u) << time;
  }
}

TEST_F(RefusalLogTest, ManyFramesEndInOneLine) {
  int lines = 0;
  for (int i = 0; i < 5000; ++i)
    lines += line("frame_" + std::to_string(i), 0).has_value();
  EXPECT_EQ(lines, 11);
}

TEST_F(RefusalLogTest, IsQuietExactlyIfThereIsNoLine) {
  int quiet = 0;
  for (int i = 0; i < 20000; ++i) {
    const double time = i * 0.01;
    const std::string frame = "frame_" + std::to_string(i % (i % 4000 < 2000 ? 97 : 5));
    const bool is_quiet = log_.isQuiet(frame, ros::SteadyTime(1000 + time));
    ASSERT_EQ(line(frame, time).has_value(), !is_quiet) << time;
    quiet += is_quiet;
  }
  EXPECT_GT(quiet, 19000);
}

TEST_F(RefusalLogTest, LongAndStrangeNamesAreMadeFitForALog) {
  const std::string text = line("a\n\x1b[31m\xff" + std::string(100000, 'x'), 0).value();
  EXPECT_EQ(text.find("a transform of \"a??[31m?xx"), 0u);
  EXPECT_LT(text.size(), 200u);
}

TEST_F(RefusalLogTest, ReasonsAreMadeFitForALogToo) {
  const std::string reason = "cannot use /tmp/a\n\x1b[31m" + std::string(100000, 'x') + "; mend it";
  const std::string text = log_.line("a", reason, "/b", ros::SteadyTime(1000)).value();
  EXPECT_NE(text.find("is refused: cannot use /tmp/a??[31mxx"), std::string::npos) << text;
  EXPECT_EQ(text.substr(text.size() - 9), "; mend it");
  EXPECT_LT(text.size(), 700u);
}

}  // namespace
}  // namespace link_bounds

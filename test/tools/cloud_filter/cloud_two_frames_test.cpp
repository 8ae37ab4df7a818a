// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds of two frames on one topic: what the first one lacks says nothing of one of another frame.
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

class WaitingFilter : public FilterInProcess {
 protected:
  WaitingFilter() : FilterInProcess(10, "pass") {}
};

TEST_F(WaitingFilter, ACloudThatWasNotTriedIsNotPassedOnForWhatAnotherFrameLacks) {
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  send("nowhere");
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  scans_.publish(sensor_msgs::LaserScan());
  ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it has no stamp";
  for (std::size_t i = 0; i < FilterHealth::kMaxWaiting + 1; ++i)
    send("elsewhere");
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  gate_.open();
  ASSERT_TRUE(isServed([this] { return values_["passed unfiltered"] == "1"; }));
  EXPECT_EQ(values_[kTooMany], "1");
  EXPECT_EQ(values_["dropped"], "2") << "the scan, too";
}

}  // namespace
}  // namespace link_bounds

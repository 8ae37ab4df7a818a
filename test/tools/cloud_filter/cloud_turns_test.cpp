// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud waits while the filter is busy with others.
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

class PassingFilter : public FilterInProcess {
 protected:
  PassingFilter() : FilterInProcess(0, "pass") {}
};

TEST_F(PassingFilter, ACloudThatWaitsLongForItsTurnIsLateAndNeverPassed) {
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  send("cube", ros::Time());
  ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it has no stamp";
  send("cube");
  send("nowhere");
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  const ros::SteadyTime heard = ros::SteadyTime::now();
  ASSERT_TRUE(becomesTrue([&] { return (ros::SteadyTime::now() - heard).toSec() > 0.3; }));
  gate_.open();
  ASSERT_TRUE(isServed([this] { return message_.find("are sent late") != std::string::npos; }));
  ASSERT_TRUE(isServed([this] { return values_["dropped"] == "2"; }));
  EXPECT_EQ(values_["filtered"], "1");
  EXPECT_EQ(values_["passed unfiltered"], "0");
  send("nowhere");
  EXPECT_TRUE(isServed([this] { return values_["passed unfiltered"] == "1"; })) << "it is in time";
}

}  // namespace
}  // namespace link_bounds

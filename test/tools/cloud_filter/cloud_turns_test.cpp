// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud waits while the filter is busy with others.
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

TEST_F(FilterInProcess, ACloudThatWaitsLongForItsTurnIsLate) {
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  send("cube");
  ASSERT_TRUE(isServed([this] { return values_["filtered"] == "1"; }));
  send();
  ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); }));
  send("cube");
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  const ros::SteadyTime heard = ros::SteadyTime::now();
  ASSERT_TRUE(becomesTrue([&] { return (ros::SteadyTime::now() - heard).toSec() > 0.3; }));
  gate_.open();
  ASSERT_TRUE(isServed([this] { return message_.find("are sent late") != std::string::npos; }));
}

}  // namespace
}  // namespace link_bounds

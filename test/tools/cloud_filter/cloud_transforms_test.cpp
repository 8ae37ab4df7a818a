// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// More transforms come than may wait while the filter is busy.
#include <tf2_msgs/TFMessage.h>

#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

TEST_F(FilterInProcess, ThatTransformsMayBeLostIsTold) {
  const ros::Publisher tf = node_.advertise<tf2_msgs::TFMessage>("/tf", 2 * TfReceiver::kQueue);
  std::size_t heard = 0;
  const ros::Subscriber witness = node_.subscribe<tf2_msgs::TFMessage>(
      "/tf", 2 * TfReceiver::kQueue, [&heard](const tf2_msgs::TFMessageConstPtr&) { ++heard; });
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  send("cube", ros::Time());
  ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it has no stamp";
  for (std::uint32_t i = 0; i < TfReceiver::kQueue; ++i)
    tf.publish(tf2_msgs::TFMessage());
  ASSERT_TRUE(isServed([&heard] { return heard == TfReceiver::kQueue; }));
  gate_.open();
  EXPECT_TRUE(isServed([this] {
    return message_.find("transforms may have been lost, because filtering took too long") !=
           std::string::npos;
  }));
}

}  // namespace
}  // namespace link_bounds

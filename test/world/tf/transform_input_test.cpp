// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What late publishers cost, and who is named.
#include "world/tf/transform_input.h"

#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

class TransformInputTest : public testing::Test {
 protected:
  /// One message of so many edges. Returns how often it asked for the name of the publisher.
  int send(const std::string& publisher, double stamp, int count) {
    std::vector<geometry_msgs::TransformStamped> transforms;
    for (int i = 0; i < count; ++i)
      transforms.push_back(edge("base", "link_" + std::to_string(i), stamp,
                                Eigen::Quaterniond::Identity(), {1, 0, 0}));
    int asked = 0;
    const auto name = [&] {
      ++asked;
      return publisher;
    };
    input_.add({transforms.begin(), transforms.end()}, false, name, clock_, ros::Time(1000),
               ros::SteadyTime::now(), tf_);
    return asked;
  }

  TransformBuffer tf_;
  ClockWatch clock_;
  TransformInput input_;
};

TEST_F(TransformInputTest, AsksForTheNameOnceForEachLateMessage) {
  EXPECT_EQ(send("/good", 1000, 50), 0);
  EXPECT_TRUE(input_.takeLatePublishers().empty());
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(send("/late", 995 + 0.01 * i, 50), 1);
}

TEST_F(TransformInputTest, EachLatePublisherIsNamedAlone) {
  send("/good", 1000, 3);
  for (int i = 0; i < 20; ++i)
    send("/late_" + std::to_string(i), 995 + 0.01 * i, 3);
  const LateTexts late = input_.takeLatePublishers();
  ASSERT_EQ(late.size(), 20u);
  EXPECT_EQ(late.at("/late_0"), "by 5.000000 s (frame link_2)");
  input_.forgetLog();
  EXPECT_TRUE(input_.takeLatePublishers().empty());
}

}  // namespace
}  // namespace link_bounds

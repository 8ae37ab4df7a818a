// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A box, its message, and the box again.
#include "link_bounds/ros/messages.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

const Aabb kBox(Eigen::Vector3d(-1, 2, 3), Eigen::Vector3d(4, 5, 6e300));

TEST(Messages, ABoxKeepsItsCornersNameAndTime) {
  const AxisAlignedBox message = toMessage("arm", kBox, ros::Time(7, 8));
  EXPECT_EQ(message.name, "arm");
  EXPECT_EQ(message.stamp, ros::Time(7, 8));
  EXPECT_EQ(message.min.x, -1);
  EXPECT_EQ(message.min.y, 2);
  EXPECT_EQ(message.min.z, 3);
  EXPECT_EQ(message.max.x, 4);
  EXPECT_EQ(message.max.y, 5);
  EXPECT_EQ(message.max.z, 6e300);
}

TEST(Messages, TheTimeOfWhatCannotMoveIsZero) {
  EXPECT_TRUE(toMessage("arm", kBox).stamp.isZero());
}

TEST(Messages, ABoxComesBackFromItsMessage) {
  const Aabb box = toAabb(toMessage("arm", kBox));
  EXPECT_EQ(box.min(), kBox.min());
  EXPECT_EQ(box.max(), kBox.max());
}

}  // namespace
}  // namespace link_bounds

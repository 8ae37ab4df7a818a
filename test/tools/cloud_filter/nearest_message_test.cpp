// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/nearest_message.h"

#include <gtest/gtest.h>

#include <limits>

namespace link_bounds {
namespace {

ros::Time stampOf(std::int64_t nanoseconds) {
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const NearestPoint point{0, nanoseconds, 0, 0, origin, origin, false};
  return nearestMessage({}, {"hand"}, {point}, {}).distances.at(0).stamp;
}

/// A point may have any time where no transform moves.
TEST(NearestMessage, TimesThatRosDoesNotHaveAreItsFirstAndItsLast) {
  const ros::Time last(4'294'967'295, 999'999'999);
  EXPECT_EQ(stampOf(static_cast<std::int64_t>(last.toNSec())), last);
  EXPECT_EQ(stampOf(std::numeric_limits<std::int64_t>::max()), last);
  EXPECT_EQ(stampOf(1'000'000'001), ros::Time(1, 1));
  EXPECT_EQ(stampOf(-1), ros::Time());
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The polygon contains the box, and its corners have the documented order.
#include "node/outputs/messages/footprint.h"

#include <gtest/gtest.h>

#include "node/outputs/messages/box_message.h"
#include "testing/brute_force.h"

namespace link_bounds {
namespace {

AxisAlignedBoxArray groupsOf(const BoxState& robot) {
  AxisAlignedBoxArray message;
  BoxFiller filler(message, "base");
  filler.add("robot", robot);
  filler.add("arm", {Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)), 0, true});
  filler.finish();
  return message;
}

AxisAlignedBoxArray groupsOf(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  return groupsOf(BoxState{Aabb(min, max), 0, false});
}

TEST(Footprint, GoesAroundFromTheSmallestCorner) {
  const auto polygon = footprintOf(groupsOf({-1, -2, -3}, {4, 5, 6}));
  ASSERT_TRUE(polygon);
  const std::vector<std::array<float, 2>> expected{{-1, -2}, {4, -2}, {4, 5}, {-1, 5}};
  ASSERT_EQ(polygon->points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(polygon->points[i].x, expected[i][0]);
    EXPECT_EQ(polygon->points[i].y, expected[i][1]);
    EXPECT_EQ(polygon->points[i].z, 0);
  }
}

TEST(Footprint, ContainsTheBox) {
  brute_force::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d a = random.vector(random.magnitude(-6, 6));
    const Eigen::Vector3d b = random.vector(random.magnitude(-6, 6));
    const Eigen::Vector3d min = a.cwiseMin(b);
    const Eigen::Vector3d max = a.cwiseMax(b);
    const auto points = footprintOf(groupsOf(min, max)).value().points;
    EXPECT_TRUE(points[0].x <= min.x() && points[0].y <= min.y());
    EXPECT_TRUE(points[2].x >= max.x() && points[2].y >= max.y());
    EXPECT_LE(min.x() - points[0].x, 1.2e-7 * std::abs(min.x()));
    EXPECT_LE(points[2].y - max.y(), 1.2e-7 * std::abs(max.y()));
  }
}

TEST(Footprint, HasNoMinusZero) {
  for (const double zero : {-0.0, -1e-60}) {  // rounds up to -0 in float32
    const auto polygon = footprintOf(groupsOf({-1, -1, 0}, {zero, zero, 1}));
    ASSERT_TRUE(polygon);
    for (const auto& point : polygon->points) {
      EXPECT_FALSE(point.x == 0 && std::signbit(point.x)) << zero;
      EXPECT_FALSE(point.y == 0 && std::signbit(point.y)) << zero;
    }
  }
}

TEST(Footprint, NoneOfARobotThatIsNotCompleteOrTooLarge) {
  const Aabb box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
  EXPECT_TRUE(footprintOf(groupsOf(BoxState{box, 0, false})));
  EXPECT_EQ(whyNoFootprint(groupsOf(BoxState{box, 0, false})), "");
  EXPECT_FALSE(footprintOf(groupsOf(BoxState{box, 0, true})));
  EXPECT_FALSE(footprintOf(groupsOf(BoxState{std::nullopt, 0, false})));
  EXPECT_FALSE(footprintOf(groupsOf(BoxState{std::nullopt, 0, true})));
  EXPECT_FALSE(footprintOf(AxisAlignedBoxArray()));
  EXPECT_FALSE(footprintOf(groupsOf({0, 0, 0}, {1, 1e39, 1})));
  EXPECT_EQ(whyNoFootprint(groupsOf(BoxState{box, 0, true})), "group robot is incomplete");
  EXPECT_EQ(whyNoFootprint(AxisAlignedBoxArray()), "no link has a box");
  EXPECT_EQ(whyNoFootprint(groupsOf({0, 0, 0}, {1, 1e39, 1})),
            "box robot is too large for float32");
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The farthest point of a set, and what a set says of itself.
#include "link_bounds/geometry/support/point_set.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

using Points = std::vector<Eigen::Vector3f>;

TEST(PointSet, FarthestIsAPointOfTheSetAsFarAsTheExtent) {
  brute_force::Random random(11);
  for (const std::size_t count : {1u, 3u, 5u, 40u, 1000u}) {
    const Points points = random.points(count, 0.5);
    std::vector<Eigen::Vector3d> in_double;
    for (const Eigen::Vector3f& point : points)
      in_double.push_back(point.cast<double>());
    const PointSet set(points);
    const std::shared_ptr<const double> xyz(std::shared_ptr<void>(), in_double[0].data());
    const PointSet scanned(xyz, count);
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector3d direction = random.vector(random.magnitude(-3, 3));
      Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
      rows.row(0) = direction;
      const double high = set.extents(rows).high[0];
      for (const PointSet* any : {&set, &scanned}) {
        const Eigen::Vector3d farthest = any->farthest(direction);
        ASSERT_EQ(brute_force::reach(direction, farthest), high);
        ASSERT_NE(std::find(in_double.begin(), in_double.end(), farthest), in_double.end());
      }
    }
  }
}

TEST(PointSet, MagnitudeIsTheLargestCoordinatePerAxis) {
  const PointSet set({{1, -5, 2}, {-3, 4, 2}});
  EXPECT_EQ(set.magnitude(), Eigen::Vector3d(3, 5, 2));
}

TEST(PointSet, CountsPointsAndBytes) {
  brute_force::Random random(10);
  const PointSet set(random.points(1000, 1));
  EXPECT_GT(set.size(), 0u);
  EXPECT_LE(set.size(), 1000u);
  EXPECT_EQ(set.points().size(), set.size());
  EXPECT_GE(set.bytes(), set.size() * sizeof(Eigen::Vector3f));
}

}  // namespace
}  // namespace link_bounds

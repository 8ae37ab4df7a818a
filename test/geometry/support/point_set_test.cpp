// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extents equal those of the scan over all points, to the bit.
#include "link_bounds/geometry/support/point_set.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr int kRandomDirections = 500;

/// Under random maps and those whose ties are hardest: the axes and their signed permutations.
void expectEqualsBruteForce(const Points& points, std::uint64_t seed) {
  const PointSet set(points);
  brute_force::Random random(seed);
  std::vector<Eigen::Matrix3d> maps{Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity(),
                                    Eigen::Matrix3d::Zero()};
  for (const double degrees : {30.0, 45.0, 90.0, 180.0}) {
    maps.push_back(brute_force::turned(degrees, Eigen::Vector3d::UnitX()));
    maps.push_back(brute_force::turned(degrees, Eigen::Vector3d::UnitZ()));
  }
  for (int i = 0; i < kRandomDirections; ++i)
    maps.push_back(random.rotation());
  for (int i = 0; i < kRandomDirections; ++i)
    maps.push_back(random.affine(0).linear());
  for (const Eigen::Matrix3d& map : maps) {
    const Extents actual = set.extents(map);
    const Extents expected = brute_force::extents(points, map);
    ASSERT_EQ(actual.low, expected.low) << map;
    ASSERT_EQ(actual.high, expected.high) << map;
  }
}

TEST(PointSet, EqualsBruteForceForClouds) {
  brute_force::Random random(1);
  for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 15u, 16u, 17u, 33u, 1000u}) {
    SCOPED_TRACE(count);
    expectEqualsBruteForce(random.points(count, 0.5), count);
  }
}

TEST(PointSet, EqualsBruteForceForABall) {
  brute_force::Random random(2);
  Points points;
  for (int i = 0; i < 3000; ++i)
    points.push_back(random.vector(1).normalized().cast<float>());
  expectEqualsBruteForce(points, 2);
}

TEST(PointSet, EqualsBruteForceFarFromTheOrigin) {
  brute_force::Random random(3);
  expectEqualsBruteForce(random.points(500, 0.1, {1000, -2000, 3000}), 3);
}

TEST(PointSet, EqualsBruteForceForAPoint) {
  expectEqualsBruteForce({{1, -2, 3}}, 4);
}

TEST(PointSet, EqualsBruteForceForASegment) {
  Points points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back(static_cast<float>(i) * Eigen::Vector3f(0.01f, 0.02f, -0.03f));
  }
  expectEqualsBruteForce(points, 5);
}

TEST(PointSet, EqualsBruteForceForPlanes) {
  for (int flat = 0; flat < 3; ++flat) {
    brute_force::Random random(6);
    Points points = random.points(300, 1);
    for (Eigen::Vector3f& point : points)
      point[flat] = 0.25f;
    expectEqualsBruteForce(points, 6);
  }
}

TEST(PointSet, EqualsBruteForceForATessellatedPlate) {
  Points points;
  for (int i = 0; i < 400; ++i) {
    points.emplace_back(static_cast<float>(i % 20) * 0.1f, static_cast<float>(i / 20) * 0.1f,
                        i % 2 ? 0.0f : 0.05f);
  }
  expectEqualsBruteForce(points, 7);
}

TEST(PointSet, EqualsBruteForceForEqualPoints) {
  expectEqualsBruteForce(Points(64, Eigen::Vector3f(0.1f, 0.2f, 0.3f)), 8);
}

TEST(PointSet, EqualsBruteForceForTheExtremesOfFloat) {
  expectEqualsBruteForce({{3.4e38f, -3.4e38f, 1e-45f}, {1e-38f, 3.4e38f, -1e-45f}}, 9);
}

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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Points in double: extents equal those of the oracle to the bit, and boxes contain in quadruple
// precision what they bound.
#include <gtest/gtest.h>

#include "geometry/support/query/direction_query.h"
#include "link_bounds/geometry/shape/shape.h"
#include "testing/brute_force.h"
#include "testing/linear_maps.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr int kMaps = 450;
constexpr int kClouds = 30;
constexpr int kPosesPerCloud = 50;
constexpr double kUnderflow = 1e-307;  // what shape.h admits against it [m]

PointSet setOf(const Points& points) {
  const auto owner = std::make_shared<const Points>(points);
  return {std::shared_ptr<const double>(owner, owner->front().data()), owner->size()};
}

Points cloud(brute_force::Random& random, std::size_t count, double size,
             const Eigen::Vector3d& center = Eigen::Vector3d::Zero()) {
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(center + random.vector(size));
  return points;
}

void expectEqualsBruteForce(const Points& points, std::uint64_t seed) {
  const PointSet set = setOf(points);
  LinearMaps maps(seed);
  for (int i = 0; i < kMaps; ++i) {
    const Eigen::Matrix3d map = maps.next();
    const Extents expected = brute_force::extents(points, map);
    for (const QueryPath path : kQueryPaths) {
      if (!isSupported(path)) continue;
      useQueryPath(path);
      const Extents actual = set.extents(map);
      ASSERT_EQ(actual.low, expected.low) << map;
      ASSERT_EQ(actual.high, expected.high) << map;
    }
  }
}

void expectContainment(const Points& points, const std::shared_ptr<const PointSet>& set,
                       const Eigen::Affine3d& pose) {
  const auto box =
      worldBox({set, Solid::kNone, Eigen::Vector3d::Zero(), pose}, Eigen::Affine3d::Identity());
  ASSERT_TRUE(box);
  ASSERT_EQ(faultOf(*box, points, pose, kUnderflow), "") << pose.matrix();
}

void expectContainment(const Points& points, brute_force::Random& random) {
  const auto set = std::make_shared<const PointSet>(setOf(points));
  for (int i = 0; i < kPosesPerCloud; ++i) {
    expectContainment(points, set, random.rigid(random.magnitude(-3, 6)));
    expectContainment(points, set, random.affine(random.magnitude(-3, 6)));
  }
}

TEST(PointScan, EqualsBruteForceForEachNumberOfPointsLeftOver) {
  brute_force::Random random(1);
  for (std::size_t count = 1; count <= 9; ++count) {
    SCOPED_TRACE(count);
    for (int i = 0; i < 5; ++i)
      expectEqualsBruteForce(cloud(random, count, 0.5), count);
  }
}

TEST(PointScan, EqualsBruteForceWhereverTheExtremeIs) {
  for (std::size_t place = 0; place < 13; ++place) {
    SCOPED_TRACE(place);
    Points points(13, Eigen::Vector3d(0.1, 0.2, 0.3));
    points[place] = {7, -8, 9};
    expectEqualsBruteForce(points, place);
  }
}

TEST(PointScan, EqualsBruteForceForAThousandPoints) {
  brute_force::Random random(2);
  expectEqualsBruteForce(cloud(random, 1000, 3), 2);
}

TEST(PointScan, EqualsBruteForceFarAwayAndTiny) {
  brute_force::Random random(3);
  expectEqualsBruteForce(cloud(random, 101, 0.1, {1e6, -2e6, 3e6}), 3);
  expectEqualsBruteForce(cloud(random, 102, 1e-200), 4);
  expectEqualsBruteForce(cloud(random, 103, 1e-320), 5);
}

TEST(PointScan, KeepsTheDigitsThatFloatLacks) {
  const PointSet set = setOf({{1e6, 0, 0}, {1e6 + 1e-9, 0, 0}});
  const Extents extents = set.extents(Eigen::Matrix3d::Identity());
  EXPECT_LT(extents.low.x(), extents.high.x());
}

TEST(PointScan, ZerosArePositive) {
  for (const std::size_t count : {1u, 2u, 9u}) {
    const PointSet set = setOf(Points(count, Eigen::Vector3d::Constant(-0.0)));
    for (const QueryPath path : kQueryPaths) {
      if (!isSupported(path)) continue;
      useQueryPath(path);
      const Extents extents = set.extents(Eigen::Matrix3d::Ones());
      for (int k = 0; k < 3; ++k) {
        EXPECT_FALSE(std::signbit(extents.low[k]));
        EXPECT_FALSE(std::signbit(extents.high[k]));
      }
    }
  }
}

TEST(PointScan, KnowsItsPointsMagnitudeAndSize) {
  const PointSet set = setOf({{1, -5, 2}, {-3, 4, 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, -7}});
  EXPECT_EQ(set.magnitude(), Eigen::Vector3d(3, 5, 7));
  EXPECT_EQ(set.size(), 5u);
  EXPECT_FALSE(set.table());
  EXPECT_GE(set.bytes(), 5 * sizeof(Eigen::Vector3d));
}

TEST(PointScanContainment, RandomClouds) {
  brute_force::Random random(5);
  for (int i = 0; i < kClouds; ++i)
    expectContainment(cloud(random, 50, random.magnitude(-6, 3)), random);
}

TEST(PointScanContainment, AThousandKilometresFromTheirOrigin) {
  brute_force::Random random(6);
  for (int i = 0; i < kClouds; ++i) {
    const Eigen::Vector3d far_away = 1e6 * random.vector(1).normalized();
    expectContainment(cloud(random, 50, random.magnitude(-9, 0), far_away), random);
  }
}

TEST(PointScanContainment, TinyAndHuge) {
  brute_force::Random random(7);
  for (int i = 0; i < kClouds; ++i) {
    expectContainment(cloud(random, 9, random.magnitude(-323, -290)), random);
    expectContainment(cloud(random, 9, random.magnitude(20, 29)), random);
  }
}

TEST(PointScanContainment, TranslationsThatCancelTheReach) {
  brute_force::Random random(8);
  for (int i = 0; i < kClouds * kPosesPerCloud; ++i) {
    const Points points = cloud(random, 1, 1e3);
    Eigen::Affine3d pose = random.rigid(0);
    pose.translation() = -(pose.linear() * points[0]);
    expectContainment(points, std::make_shared<const PointSet>(setOf(points)), pose);
  }
}

}  // namespace
}  // namespace link_bounds

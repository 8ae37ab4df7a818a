// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Degenerate and other hard sets of points: extents equal those of the scan, to the bit.
#include "geometry/support/table/direction_table.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <stdexcept>

#include "geometry/support/query/direction_query.h"
#include "testing/exactness.h"
#include "testing/linear_maps.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr int kMaps = 5000;

Exactness compareAll(const Points& points, std::uint64_t seed, int count = kMaps,
                     const Eigen::Matrix3d& levelling = Eigen::Matrix3d::Identity()) {
  const PointSet set(points);
  LinearMaps maps(seed);
  Exactness result;
  for (int i = 0; i < count; ++i)
    result += compare(points, set, maps.next() * levelling);
  return result;
}

void expectExact(const Points& points, std::uint64_t seed, int count = kMaps) {
  const Exactness found = compareAll(points, seed, count);
  EXPECT_EQ(found.wrong, 0) << found.wrong_map;
  EXPECT_EQ(found.ties, 0);
}

/// Where points tie within the rounding of the sum, the table may hold another one of them.
void expectExactButForTies(const Points& points, std::uint64_t seed,
                           const Eigen::Matrix3d& levelling = Eigen::Matrix3d::Identity()) {
  const Exactness found = compareAll(points, seed, kMaps, levelling);
  EXPECT_EQ(found.wrong, 0) << found.wrong_map;
  EXPECT_LT(found.ties, found.compared / 100);
  std::cout << "ties within rounding: " << found.ties << " of " << found.compared << " faces\n";
}

/// Without a single tie, under turns about the axes and under random maps.
void expectExactUnderFewMaps(const Points& points, std::uint64_t seed) {
  const PointSet set(points);
  brute_force::Random random(seed);
  Exactness found;
  const auto add = [&](const Eigen::Matrix3d& map) { found += compare(points, set, map); };
  for (const double scale : {1.0, -1.0, 0.0})
    add(scale * Eigen::Matrix3d::Identity());
  for (const double degrees : {30.0, 45.0, 90.0, 180.0}) {
    add(brute_force::turned(degrees, Eigen::Vector3d::UnitX()));
    add(brute_force::turned(degrees, Eigen::Vector3d::UnitZ()));
  }
  for (int i = 0; i < 500; ++i)
    add(random.rotation());
  for (int i = 0; i < 500; ++i)
    add(random.affine(0).linear());
  EXPECT_EQ(found.wrong, 0) << found.wrong_map;
  EXPECT_EQ(found.ties, 0);
}

/// Both faces of a plate of 2 x 2 x 0.1, divided into 20 x 20 squares.
Points plate(const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  Points points;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      for (const double z : {0.0, 0.1})
        points.push_back((turn * Eigen::Vector3d(0.1 * i - 1, 0.1 * j - 1, z)).cast<float>());
    }
  }
  return points;
}

Points onSphere(int count) {
  brute_force::Random random(3);
  Points points;
  for (int i = 0; i < count; ++i)
    points.push_back(random.vector(1).normalized().cast<float>());
  return points;
}

Points alongLine(int count, const Eigen::Vector3f& step) {
  Points points;
  for (int i = 0; i < count; ++i)
    points.push_back(Eigen::Vector3f(0.1f, 0.2f, 0.3f) + static_cast<float>(i) * step);
  return points;
}

Points inPlane(Points points, int flat) {
  for (Eigen::Vector3f& point : points)
    point[flat] = 0.25f;
  return points;
}

TEST(DirectionTable, Point) {
  expectExact({{0.1f, -0.2f, 0.3f}}, 1);
}

TEST(DirectionTable, Segment) {
  expectExact({{0.1f, -0.2f, 0.3f}, {1, 2, 3}}, 2);
}

TEST(DirectionTable, Triangle) {
  expectExact({{0.1f, -0.2f, 0.3f}, {1, 2, 3}, {-1, 0, 0.5f}}, 3);
}

TEST(DirectionTable, AllEqual) {
  expectExact(Points(64, Eigen::Vector3f(0.1f, -0.2f, 0.3f)), 4);
}

TEST(DirectionTable, Collinear) {
  expectExact(alongLine(100, {0.25f, 0.5f, -0.125f}), 5);
  expectExact(alongLine(100, {0, 0, 1}), 6);
}

TEST(DirectionTable, NearlyCollinear) {
  // Rounded to float, these points leave their line by less than an ulp.
  expectExactButForTies(alongLine(100, {0.013f, 0.027f, -0.031f}), 7);
  Points from_origin;
  for (int i = 0; i <= 100; ++i)
    from_origin.push_back(static_cast<float>(i) * Eigen::Vector3f(0.01f, 0.02f, -0.03f));
  expectExactUnderFewMaps(from_origin, 5);
}

TEST(DirectionTable, Plane) {
  // Seen along its normal, all points of a plane tie.
  brute_force::Random random(8);
  for (int flat = 0; flat < 3; ++flat) {
    expectExactButForTies(inPlane(random.points(300, 1), flat), 8);
    expectExactUnderFewMaps(inPlane(brute_force::Random(6).points(300, 1), flat), 6);
  }
}

TEST(DirectionTable, TessellatedPlate) {
  expectExact(plate(), 9);
  Points folded;
  for (int i = 0; i < 400; ++i)
    folded.emplace_back(static_cast<float>(i % 20) * 0.1f, static_cast<float>(i / 20) * 0.1f,
                        i % 2 ? 0.0f : 0.05f);
  expectExactUnderFewMaps(folded, 7);
}

TEST(DirectionTable, Sphere) {
  expectExact(onSphere(10000), 10, 500);
}

/// More points than are examined one by one.
TEST(DirectionTable, FineSphere) {
  const Points points = onSphere(kIsSanitized ? 8000 : 140000);
  expectExact(points, 11, 100);
  EXPECT_LT(PointSet(points).bytes(), 64 * points.size());
}

/// The first part of the points is the ball, so the plate is examined as coarsely as that.
TEST(DirectionTable, AFinePlateAfterABall) {
  const int ball = kIsSanitized ? 8000 : 70000;
  Points points = onSphere(ball);
  const int side = kIsSanitized ? 90 : 450;
  for (int i = 0; i < side * side; ++i) {
    const auto x = static_cast<float>(i / side), y = static_cast<float>(i % side);
    points.emplace_back(0.01f * x, 0.01f * y, 2.0f);
  }
  expectExact(points, 12, 100);
  EXPECT_LT(PointSet(points).size(), static_cast<std::size_t>(ball) + 1000);
}

TEST(DirectionTable, AnInterruptEndsTheWork) {
  const Points points = onSphere(repetitions(140000));
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
  std::chrono::duration<double> longest(0);
  std::size_t calls = 0;
  const auto measure = [&] {
    ++calls;
    longest = std::max<std::chrono::duration<double>>(longest, Clock::now() - last);
    last = Clock::now();
  };
  const PointSet whole(points, measure);
  measure();
  EXPECT_GT(calls, static_cast<std::size_t>(repetitions(100)));
  std::cout << "asked " << calls << " times, at most " << longest.count() << " s apart\n";
  EXPECT_LT(longest.count(), 1.0);
  for (const std::size_t end : {std::size_t{1}, calls / 2, calls - 1}) {
    std::size_t left = end;
    const auto interrupt = [&left] {
      if (--left == 0) throw std::runtime_error("enough");
    };
    EXPECT_THROW(PointSet(points, interrupt), std::runtime_error);
    EXPECT_EQ(left, 0u);
  }
}

TEST(DirectionTable, TwoLongLines) {
  // Seen across a line, its points come to a tie; to halve cones until it parts would never end.
  Points points;
  const int count = kIsSanitized ? 5000 : 20000;
  for (int i = 0; i < count; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(count);
    points.insert(points.end(), {{part, 0, 0}, {part, part, 0}});
  }
  points.emplace_back(1, 1, 1);
  expectExact(points, 21, 20);
}

TEST(DirectionTable, LargeSetsInParts) {
  brute_force::Random random(22);
  Points points = onSphere(kIsSanitized ? 50000 : 200000);
  for (Eigen::Vector3f& point : points)
    point *= 1 + 0.01f * random.vector(1).cast<float>().x();
  expectExact(points, 23, 30);
}

TEST(DirectionTable, SmallSets) {
  brute_force::Random random(11);
  for (const std::size_t count : {4u, 15u, 16u, 17u, 18u, 33u, 1u, 2u, 3u, 5u, 1000u}) {
    SCOPED_TRACE(count);
    expectExact(random.points(count, 0.5), count, 1000);
  }
}

TEST(DirectionTable, FarFromTheOrigin) {
  brute_force::Random random(12);
  expectExact(random.points(500, 0.1, {1000, -2000, 3000}), 12);
}

TEST(DirectionTable, ExtremesOfFloat) {
  Points points{{3.4e38f, -3.4e38f, 1e-45f}, {1e-38f, 3.4e38f, -1e-45f}};
  expectExact(points, 9);
  for (int i = 0; i < 30; ++i)
    points.emplace_back(static_cast<float>(i) * 1e37f, static_cast<float>(-i) * 1e36f, 1e-42f);
  expectExact(points, 13);
}

TEST(DirectionTable, PlateTiltedBy3To4To5) {
  Eigen::Matrix3d tilt;
  tilt << 1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8;
  expectExactButForTies(plate(tilt), 14);
  expectExactButForTies(plate(tilt), 15, tilt.transpose());
}

TEST(DirectionTable, PlateTiltedBy45Degrees) {
  const Eigen::Matrix3d tilt = brute_force::turned(45, Eigen::Vector3d::UnitX());
  expectExactButForTies(plate(tilt), 16);
  expectExactButForTies(plate(tilt), 17, tilt.transpose());
}

TEST(DirectionTable, ZeroIsPositive) {
  for (const QueryPath path : kQueryPaths) {
    if (!isSupported(path)) continue;
    useQueryPath(path);
    const Extents found =
        extents(directionTable({{1, 2, 3}, {-1, -2, -3}}), Eigen::Matrix3d::Constant(-0.0));
    for (int k = 0; k < 3; ++k) {
      EXPECT_FALSE(std::signbit(found.low[k]));
      EXPECT_FALSE(std::signbit(found.high[k]));
    }
  }
}

TEST(DirectionTable, WhatIsNoNumberDoesNoHarm) {
  const DirectionTable table = directionTable(onSphere(1000));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e308, -1e308}) {
    for (const QueryPath path : kQueryPaths) {
      if (!isSupported(path)) continue;
      useQueryPath(path);
      Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
      map(1, 1) = bad;
      const Extents found = extents(table, map);
      EXPECT_NEAR(found.high[0], 1, 0.1);
      EXPECT_NEAR(found.low[2], -1, 0.1);
      extents(table, Eigen::Matrix3d::Constant(bad));
    }
  }
}

TEST(DirectionTable, GridAndMemoryFollowTheRules) {
  brute_force::Random random(16);
  EXPECT_EQ(directionTable(random.points(16, 1)).grid.side, 1);
  EXPECT_EQ(directionTable(random.points(17, 1)).grid.side, 8);
  for (const int count : {100, 1000, 10000}) {
    const PointSet set(onSphere(count));
    EXPECT_EQ(set.size(), static_cast<std::size_t>(count));
    EXPECT_LE(set.bytes(), std::max<std::size_t>(96 * 1024, 48 * set.size()));
  }
}

TEST(DirectionTable, CellsShareLists) {
  const DirectionTable table = directionTable(onSphere(400));
  EXPECT_EQ(table.cells.size(), 1024u);
  EXPECT_LT(3 * table.lists.size(), table.cells.size());
  EXPECT_LT(table.bytes(), 40'000u);
}

TEST(DirectionTable, OfSetsThatAreManyIsExactToo) {
  for (const Points& points : {onSphere(1000), onSphere(100), plate(), Points{{1, 2, 3}}}) {
    for (const std::size_t max_bytes : {std::size_t{0}, std::size_t{16'000}}) {
      const PointSet set(points, max_bytes);
      LinearMaps maps(max_bytes);
      Exactness result;
      for (int i = 0; i < 500; ++i)
        result += compare(points, set, maps.next());
      EXPECT_EQ(result.wrong, 0) << result.wrong_map;
    }
  }
}

TEST(DirectionTable, OfSetsThatAreManyIsAListOrAGridWithinTheLimit) {
  constexpr std::size_t kLimit = 16'000;
  const auto side = [](int points, std::size_t limit) {
    return directionTable(onSphere(points), limit).grid.side;
  };
  EXPECT_EQ(side(50, kLimit), 1) << "few points";
  EXPECT_EQ(side(200, kLimit), 8);
  EXPECT_LE(directionTable(onSphere(200), kLimit).bytes(), kLimit);
  EXPECT_EQ(side(200, 5'000), 1) << "a grid would take more";
  EXPECT_EQ(side(5'000, kLimit), 1);
  EXPECT_LE(directionTable(plate(), 0).bytes(), 1'000u) << "only what can be extreme";
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two triangles against the same distance in long double.
#include "geometry/distance/triangle_distance.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"
#include "testing/distance_oracle.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

distance_oracle::Triangle toLong(const Triangle& triangle) {
  return {triangle[0].cast<long double>(), triangle[1].cast<long double>(),
          triangle[2].cast<long double>()};
}

/// `size` is that of both triangles and of their distance.
void expectRight(const Triangle& a, const Triangle& b, double size) {
  const PointPair nearest = nearestPoints(a, b);
  const auto exact = static_cast<double>(distance_oracle::distance(toLong(a), toLong(b)));
  // Where two faces meet at a flat angle, the nearest point is only known to the root of rounding.
  ASSERT_NEAR(std::sqrt(nearest.squared), exact, 1e-7 * size);
  ASSERT_GE(std::sqrt(nearest.squared), exact - 1e-14 * size);
  ASSERT_NEAR((nearest.on_second - nearest.on_first).norm(), std::sqrt(nearest.squared),
              1e-14 * size);
  ASSERT_LE(distance_oracle::distance<long double>(nearest.on_first.cast<long double>(), toLong(a)),
            1e-9 * size);
  ASSERT_LE(
      distance_oracle::distance<long double>(nearest.on_second.cast<long double>(), toLong(b)),
      1e-9 * size);
}

/// Few values, so that corners, edges and planes often coincide.
double coarse(brute_force::Random& random) {
  return std::floor(random.uniform(-2, 3)) / 2;
}

Triangle coarseTriangle(brute_force::Random& random) {
  Triangle result;
  for (Eigen::Vector3d& corner : result) {
    const double x = coarse(random), y = coarse(random), z = coarse(random);
    corner = {x, y, z};
  }
  return result;
}

Triangle randomTriangle(brute_force::Random& random, double size) {
  return {random.vector(size), random.vector(size), random.vector(size)};
}

TEST(TriangleDistance, OfRandomTriangles) {
  brute_force::Random random(1);
  for (int i = 0; i < repetitions(100000); ++i) {
    const double size = random.magnitude(-6, 6);
    expectRight(randomTriangle(random, size), randomTriangle(random, size), size);
  }
}

TEST(TriangleDistance, OfTrianglesThatShareCornersEdgesAndPlanes) {
  brute_force::Random random(2);
  for (int i = 0; i < repetitions(200000); ++i)
    expectRight(coarseTriangle(random), coarseTriangle(random), 1);
}

TEST(TriangleDistance, OfTouchingRightTrianglesOnOneLine) {
  // FCL's routine is off by up to 0.28 m for some of these.
  brute_force::Random random(3);
  for (int i = 0; i < repetitions(50000); ++i) {
    const Eigen::Affine3d pose = random.rigid(1);
    const double along = random.uniform(0, 1);
    const Triangle a{pose * Eigen::Vector3d(0, 0, 0), pose * Eigen::Vector3d(1, 0, 0),
                     pose * Eigen::Vector3d(0, 1, 0)};
    const double angle = random.uniform(0, 2 * M_PI);
    const Triangle b{pose * Eigen::Vector3d(along, 0, 0), pose * Eigen::Vector3d(along + 1, 0, 0),
                     pose * Eigen::Vector3d(along, std::cos(angle), std::sin(angle))};
    expectRight(a, b, 1);
    ASSERT_LE(nearestPoints(a, b).squared, 1e-24);
  }
}

TEST(TriangleDistance, OfTheTwoTrianglesThatPqpGetsWrong) {
  // Issue 4 of GammaUNC/PQP: a corner of one is on an edge of the other.
  const Triangle a{{{8000.0000000000036, 6817.7672478170962, 571.00166381103077},
                    {7500.0000000000009, 6817.7672478170962, 571.00166381103077},
                    {7500.0000000000009, 6327.6345143037688, 571.00166381103077}}};
  const Triangle b{{{8000.0000000000009, 6327.6345143037670, 88.336618780016408},
                    {7500.0, 6327.6345143037670, 88.336618780016408},
                    {7500.0, 6327.6345143037670, 1015.9309593449836}}};
  expectRight(a, b, 1e4);
  EXPECT_LE(nearestPoints(a, b).squared, 1e-22);
}

TEST(TriangleDistance, OfSegmentsAndPoints) {
  brute_force::Random random(4);
  for (int i = 0; i < repetitions(100000); ++i) {
    Triangle a = randomTriangle(random, 1), b = randomTriangle(random, 1);
    a[2] = i % 2 ? a[1] : Eigen::Vector3d(a[0] + random.uniform(-1, 2) * (a[1] - a[0]));
    if (i % 3 == 0) a[1] = a[2] = a[0];
    if (i % 5 == 0) b[2] = b[0];
    if (i % 7 == 0) b[1] = b[2] = b[0];
    expectRight(a, b, 1);
    expectRight(b, a, 1);
  }
}

TEST(TriangleDistance, OfNeedles) {
  brute_force::Random random(5);
  for (int i = 0; i < repetitions(100000); ++i) {
    Triangle a = randomTriangle(random, 1), b = randomTriangle(random, 1);
    a[2] = a[0] + random.uniform(0, 1) * (a[1] - a[0]) + random.vector(random.magnitude(-14, -3));
    b[2] = b[1] + random.vector(random.magnitude(-14, -3));
    expectRight(a, b, 1);
  }
}

TEST(TriangleDistance, OfNearlyParallelTriangles) {
  brute_force::Random random(6);
  for (int i = 0; i < repetitions(100000); ++i) {
    const Triangle a = randomTriangle(random, 1);
    const Eigen::Vector3d shift = random.vector(random.magnitude(-9, 0));
    const double tilt = random.magnitude(-16, -3);
    Triangle b;
    for (std::size_t k = 0; k < 3; ++k)
      b[k] = a[k] + shift + random.vector(tilt);
    expectRight(a, b, 1);
  }
}

TEST(TriangleDistance, OfTrianglesThatPierceEachOther) {
  const Triangle floor{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const Triangle wall{{{1, 1, -1}, {1, 1, 1}, {1.2, 1, 3}}};
  const PointPair nearest = nearestPoints(floor, wall);
  EXPECT_EQ(nearest.squared, 0);
  EXPECT_TRUE(nearest.on_first.isApprox(Eigen::Vector3d(1, 1, 0)));
}

}  // namespace
}  // namespace link_bounds

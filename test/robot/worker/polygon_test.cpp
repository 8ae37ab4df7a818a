// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygons of many shapes in planes of all directions: triangles cover them and nothing else.
#include "robot/worker/polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <set>

#include "link_bounds/robot/mesh/mesh_fault.h"
#include "testing/brute_force.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Above 0 if they turn to the left.
double areaOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d x = b - a, y = c - a;
  return (x.x() * y.y() - x.y() * y.x()) / 2;
}

double areaOf(const Points& points) {
  double sum = 0;
  for (std::size_t i = 2; i < points.size(); ++i)
    sum += areaOf(points[0], points[i - 1], points[i]);
  return sum;
}

/// The polygon has these points, which turn to the left, in a plane in space.
void expectCovered(const Points& points, const Eigen::Affine3d& plane) {
  std::vector<Eigen::Vector3f> vertices{{9, 9, 9}};  // which it does not use
  for (const Eigen::Vector2d& point : points)
    vertices.push_back((plane * Eigen::Vector3d(point.x(), point.y(), 0)).cast<float>());
  CornerIndices corners(points.size());
  std::iota(corners.begin(), corners.end(), 1u);
  const auto triangles = trianglesOf(corners, vertices);
  EXPECT_EQ(triangles.size(), points.size() - 2);
  std::set<std::uint32_t> used;
  double sum = 0;
  for (const auto& triangle : triangles) {
    used.insert(triangle.begin(), triangle.end());
    const double area =
        areaOf(points[triangle[0] - 1], points[triangle[1] - 1], points[triangle[2] - 1]);
    EXPECT_GE(area, -1e-5);
    sum += area;
  }
  EXPECT_EQ(used, std::set<std::uint32_t>(corners.begin(), corners.end()));
  // As none is negative, none covers what another does, or what is outside.
  EXPECT_NEAR(sum, areaOf(points), 1e-4);
}

void expectCovered(const Points& points) {
  brute_force::Random random(1);
  for (std::size_t begin = 0; begin < points.size(); ++begin) {
    Points turned = points;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(begin), turned.end());
    expectCovered(turned, Eigen::Affine3d::Identity());
    expectCovered(turned, random.rigid(1));
  }
}

TEST(Polygon, AConvexOneIsAFan) {
  const std::vector<Eigen::Vector3f> vertices{
      {0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::vector<std::array<std::uint32_t, 3>> fan{{4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
  EXPECT_EQ(trianglesOf({4, 3, 2, 1, 0}, vertices), fan);
  EXPECT_TRUE(trianglesOf({0, 1}, vertices).empty());
  EXPECT_EQ(trianglesOf({0, 1, 2}, vertices).size(), 1u);
}

TEST(Polygon, ANotchIsNotCovered) {
  expectCovered({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});  // a U
  expectCovered({{0, 0}, {2, 1}, {0, 2}, {1, 1}});                                  // an arrow
  Points comb;
  for (int i = 0; i < 20; ++i) {
    comb.emplace_back(i, i % 2 == 0 ? 0.1 : 5);
    comb.emplace_back(i + 0.5, i % 2 == 0 ? 0.1 : 5);
  }
  comb.emplace_back(20, -1);
  comb.emplace_back(0, -1);
  std::reverse(comb.begin(), comb.end());
  expectCovered(comb);
}

TEST(Polygon, AHoleWithABridgeIsNotCovered) {
  expectCovered({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
}

TEST(Polygon, PointsOnStraightLinesAndTwiceAtOnePlaceAreKept) {
  expectCovered({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {3, 3}, {1, 1}, {0, 3}, {0, 2}, {0, 1}});
}

TEST(Polygon, ASpikeIsALine) {
  expectCovered({{0, 0}, {1, 0}, {3, 0}, {1, 0}, {1, 1}, {0, 1}});
}

TEST(Polygon, OfRandomStars) {
  brute_force::Random random(2);
  for (int run = 0; run < 300; ++run) {
    const int count = 4 + run % 30;
    Points star;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * (i + random.uniform(0, 0.9)) / count;
      star.push_back(random.uniform(0.1, 1) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    if (areaOf(star) < 0.05) continue;
    expectCovered(star, random.rigid(1));
  }
}

/// A band that goes up and down, and back along itself.
TEST(Polygon, OneThatTakesLongIsRefusedInTime) {
  if (kIsSanitized) GTEST_SKIP() << "skipped: a sanitizer makes it take minutes";
  std::vector<Eigen::Vector3f> vertices;
  constexpr int kHalf = 3000;
  for (int i = 0; i < 2 * kHalf; ++i) {
    const int along = i < kHalf ? i : 2 * kHalf - 1 - i;
    const int height = (along % 2) * 10 + (i < kHalf ? 0 : 1);
    vertices.push_back(Eigen::Vector3i(along, height, 0).cast<float>());
  }
  CornerIndices corners(vertices.size());
  std::iota(corners.begin(), corners.end(), 0u);
  EXPECT_THROW(trianglesOf(corners, vertices), MeshError);
}

TEST(Polygon, EachCornerOfOneWithoutAnAreaIsKept) {
  const std::vector<Eigen::Vector3f> line{{0, 0, 0}, {1, 1, 1}, {-2, -2, -2}, {3, 3, 3}, {0, 0, 0}};
  std::set<std::uint32_t> used;
  for (const auto& triangle : trianglesOf({0, 1, 2, 3, 4}, line))
    used.insert(triangle.begin(), triangle.end());
  EXPECT_EQ(used.size(), 5u);
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Gaps of leaves in floats against distances in long double.
#include "geometry/distance/leaf.h"

#include <gtest/gtest.h>

#include "link_bounds/geometry/box/rounding.h"
#include "testing/brute_force.h"
#include "testing/distance_oracle.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

/// Random triangles: any, thin ones, some with two equal corners, some with a common corner.
std::vector<Eigen::Vector3d> cornersOf(Random& random, double size, std::size_t triangles) {
  const Eigen::Matrix3d axes = random.rotation();
  const double width = random.sign() > 0 ? 1 : random.magnitude(-7, 0);
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    result.push_back(axes * Eigen::Vector3d(1, width, width).cwiseProduct(random.vector(size)));
    if (i > 0 && random.uniform(0, 1) < 0.1) result[i] = result[i - 1];
  }
  return result;
}

/// A tree of one leaf at a place of its own.
struct LeafCase {
  LeafCase(Random& random, double size, const Eigen::Vector3d& in_search)
      : at{random.rotation(), Eigen::Vector3d::Zero()} {
    const double scale = random.sign() > 0 ? 1 : random.magnitude(-3, 3);
    at.linear *= scale;
    size /= scale;
    const auto count = static_cast<std::uint32_t>(random.uniform(1, 8.99));
    const Eigen::Vector3d in_shape = random.vector(random.sign() > 0 ? size : 1e4 / scale);
    std::vector<Eigen::Vector3d> corners = cornersOf(random, size, count);
    for (Eigen::Vector3d& corner : corners)
      corner += in_shape;
    at.translation = in_search - at.linear * in_shape;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 0; i < count; ++i)
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    tree = triangleTree(corners, triangles);
    leaf.place(*tree, 0, at);
    rounding = 64 * kUnitRoundoff * 3 * (scale * tree->magnitude + in_search.norm());
  }

  distance_oracle::Triangle triangle(std::uint32_t i) const {
    distance_oracle::Triangle result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = at.linear.cast<long double>() * tree->corners(i)[k].cast<long double>() +
                  at.translation.cast<long double>();
    return result;
  }

  Placement at;
  std::shared_ptr<const TriangleTree> tree;
  PlacedLeaf leaf;
  double rounding;
};

/// Along the direction in which two triangles are nearest, and across all planes.
void raiseAll(const LeafCase& a, const LeafCase& b, std::uint32_t i, std::uint32_t j,
              LeafGaps& gaps) {
  const PointPair nearest = nearestPoints(placed(*a.tree, i, a.at), placed(*b.tree, j, b.at));
  const Eigen::Vector3d between = nearest.on_second - nearest.on_first;
  if (between.norm() > 1e-12) gaps.raiseAlong(between.normalized());
  gaps.raiseAcrossFirst(i);
  gaps.raiseAcrossSecond(j);
}

TEST(Leaf, ProvesNoGapThatIsNotThere) {
  Random random(1);
  std::size_t far = 0, far_and_open = 0;
  for (int n = 0; n < repetitions(20000); ++n) {
    const double size = random.magnitude(-6, 5);
    const Eigen::Vector3d where = random.vector(random.sign() > 0 ? size : 1e4);
    const LeafCase a(random, size, where);
    const LeafCase b(random, random.sign() > 0 ? size : size * random.magnitude(-3, 0),
                     where + random.vector(3 * size * random.uniform(0, 1)));
    LeafGaps gaps(a.leaf, b.leaf, a.rounding + b.rounding, random.vector(1).normalized());
    for (std::uint32_t i = 0; i < a.leaf.count; ++i) {
      for (std::uint32_t j = 0; j < b.leaf.count; ++j)
        raiseAll(a, b, i, j, gaps);
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < a.leaf.count; ++i) {
      for (std::uint32_t j = 0; j < b.leaf.count; ++j) {
        const auto exact =
            static_cast<double>(distance_oracle::distance(a.triangle(i), b.triangle(j)));
        least = std::min(least, exact);
        gaps.setFarEnough(exact * (1 - 4e-6));  // setFarEnough() rounds up
        EXPECT_TRUE(gaps.isOpen(i, j)) << n << ": " << exact << " of " << size;
        const double nearly =
            0.99 * exact - 1e-4 * (a.leaf.size + b.leaf.size) - 8 * (a.rounding + b.rounding);
        gaps.setFarEnough(nearly);
        far += nearly > 0;
        far_and_open += nearly > 0 && gaps.isOpen(i, j);
      }
    }
    EXPECT_LE(gaps.lower(), least) << n << ": of " << size;
  }
  EXPECT_GT(far, 100000u / (kIsSanitized ? 10 : 1));
  EXPECT_LT(far_and_open, far / 1000);
}

/// Where floats could overflow nothing is proven.
TEST(Leaf, OfHugeTrianglesProvesNothing) {
  Random random(2);
  for (const double size : {1e9, 1e20, 1e26}) {
    const LeafCase a(random, size, Eigen::Vector3d::Zero());
    const LeafCase b(random, size, Eigen::Vector3d(9 * size, 0, 0));
    LeafGaps gaps(a.leaf, b.leaf, 0, Eigen::Vector3d::UnitX());
    gaps.raiseAcrossFirst(0);
    gaps.raiseAcrossSecond(0);
    EXPECT_FALSE(gaps.lower() > 0);
    gaps.setFarEnough(0);
    EXPECT_TRUE(gaps.isOpen(0));
  }
}

}  // namespace
}  // namespace link_bounds

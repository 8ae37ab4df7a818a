// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Corners, quads and edges of a box, padding and the distance of two boxes.
#include "link_bounds/geometry/box/aabb.h"

#include <gtest/gtest.h>

#include <set>

#include "link_bounds/geometry/box/rounding.h"
#include "testing/brute_force.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

const Aabb kBox(Eigen::Vector3d(-1, 2, 5), Eigen::Vector3d(0, 4, 8));  // widths 1, 2, 3

Aabb boxAt(double x, double y, double z, double width) {
  const Eigen::Vector3d min(x, y, z);
  return {min, min + Eigen::Vector3d::Constant(width)};
}

Aabb pointAt(double x, double y, double z) {
  return boxAt(x, y, z, 0);
}

TEST(Aabb, CornersAreNumberedByBits) {
  const auto corner = corners(kBox);
  EXPECT_EQ(corner[0], Eigen::Vector3d(-1, 2, 5));
  EXPECT_EQ(corner[1], Eigen::Vector3d(0, 2, 5));
  EXPECT_EQ(corner[2], Eigen::Vector3d(-1, 4, 5));
  EXPECT_EQ(corner[3], Eigen::Vector3d(0, 4, 5));
  EXPECT_EQ(corner[4], Eigen::Vector3d(-1, 2, 8));
  EXPECT_EQ(corner[5], Eigen::Vector3d(0, 2, 8));
  EXPECT_EQ(corner[6], Eigen::Vector3d(-1, 4, 8));
  EXPECT_EQ(corner[7], Eigen::Vector3d(0, 4, 8));
}

TEST(Aabb, QuadsAreTheFacesCounterClockwiseFromOutside) {
  const auto corner = corners(kBox);
  const auto at = [&](int i) { return corner[static_cast<std::size_t>(i)]; };
  for (std::size_t face = 0; face < 6; ++face) {
    const auto& quad = kQuads[face];
    const int axis = static_cast<int>(face / 2);
    const double outward = face % 2 == 0 ? 1 : -1;
    const Eigen::Vector3d normal =
        (at(quad[1]) - at(quad[0])).cross(at(quad[2]) - at(quad[1])).normalized();
    EXPECT_EQ(normal, outward * Eigen::Vector3d::Unit(axis)) << "face " << face;
    const double plane = outward > 0 ? kBox.max()[axis] : kBox.min()[axis];
    for (const int i : quad)
      EXPECT_EQ(at(i)[axis], plane) << "face " << face;
    EXPECT_EQ(std::set<int>(quad.begin(), quad.end()).size(), 4u) << "face " << face;
  }
}

TEST(Aabb, ThereAreTwelveEdgesFourPerDirection) {
  const auto corner = corners(kBox);
  std::set<std::set<int>> distinct;
  std::multiset<double> lengths;
  for (const auto& edge : edges()) {
    distinct.insert({edge[0], edge[1]});
    const Eigen::Vector3d along =
        corner[static_cast<std::size_t>(edge[1])] - corner[static_cast<std::size_t>(edge[0])];
    EXPECT_EQ((along.array() != 0).count(), 1) << "an edge follows one axis";
    lengths.insert(along.norm());
  }
  EXPECT_EQ(distinct.size(), 12u);
  EXPECT_EQ(lengths, (std::multiset<double>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
}

TEST(Aabb, PaddingMovesEveryFaceOutward) {
  const Aabb box = padded(kBox, 0.25);
  EXPECT_EQ(box.min(), Eigen::Vector3d(-1.25, 1.75, 4.75));
  EXPECT_EQ(box.max(), Eigen::Vector3d(0.25, 4.25, 8.25));
}

TEST(Aabb, PaddingByZeroChangesNothing) {
  EXPECT_EQ(padded(kBox, 0).min(), kBox.min());
  EXPECT_EQ(padded(kBox, 0).max(), kBox.max());
}

TEST(Aabb, PaddingIsRoundedOutwardByLessThanOneUlp) {
  brute_force::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Aabb box = boxAt(random.uniform(-10, 10), random.uniform(-1e6, 1e6), 0.1, 0.3);
    const double distance = random.magnitude(-6, 1);
    const Aabb result = padded(box, distance);
    for (int k = 0; k < 3; ++k) {
      const Quad low = static_cast<Quad>(box.min()[k]) - static_cast<Quad>(distance);
      const Quad high = static_cast<Quad>(box.max()[k]) + static_cast<Quad>(distance);
      ASSERT_TRUE(static_cast<Quad>(result.min()[k]) <= low);
      ASSERT_TRUE(static_cast<Quad>(nextUp(result.min()[k])) > low);
      ASSERT_TRUE(static_cast<Quad>(result.max()[k]) >= high);
      ASSERT_TRUE(static_cast<Quad>(nextDown(result.max()[k])) < high);
    }
  }
}

TEST(SignedDistance, GapAlongOneAxis) {
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 1), boxAt(3, 0.5, -0.5, 1)), 2);
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 1), boxAt(0, 0, -5, 1)), 4);
}

TEST(SignedDistance, GapAcrossAnEdgeAndACornerIsEuclidean) {
  EXPECT_DOUBLE_EQ(signedDistance(boxAt(0, 0, 0, 1), boxAt(4, 5, 0, 1)), 5);     // 3, 4
  EXPECT_DOUBLE_EQ(signedDistance(boxAt(0, 0, 0, 1), boxAt(-4, 5, 13, 1)), 13);  // 3, 4, 12
}

TEST(SignedDistance, TouchingIsZero) {
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 1), boxAt(1, 0, 0, 1)), 0);
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 1), boxAt(1, 1, 1, 1)), 0);
}

TEST(SignedDistance, PenetrationIsTheShortestWayOut) {
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 4), boxAt(3, 2, 1, 4)), -1);
}

TEST(SignedDistance, NestedBoxesLeaveByTheNearestFace) {
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 10), boxAt(4, 4, 6, 2)), -4);
  EXPECT_EQ(signedDistance(boxAt(0, 0, 0, 10), boxAt(0, 0, 0, 10)), -10);
}

TEST(SignedDistance, APointIsABoxOfZeroSize) {
  EXPECT_DOUBLE_EQ(signedDistance(pointAt(0, 0, 0), pointAt(1, 2, 2)), 3);
  EXPECT_EQ(signedDistance(pointAt(0.5, 0.25, 0.5), boxAt(0, 0, 0, 1)), -0.25);
  EXPECT_EQ(signedDistance(pointAt(1, 0.5, 0.5), boxAt(0, 0, 0, 1)), 0);
  EXPECT_EQ(signedDistance(pointAt(7, 7, 7), pointAt(7, 7, 7)), 0);
}

TEST(SignedDistance, DoesNotDependOnTheOrder) {
  brute_force::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Aabb a(random.vector(1), Eigen::Vector3d::Constant(1.5));
    const Aabb b(random.vector(2), Eigen::Vector3d::Constant(2 + random.uniform(0, 3)));
    ASSERT_EQ(signedDistance(a, b), signedDistance(b, a));
  }
}

TEST(SignedDistance, HugeGapsDoNotOverflow) {
  EXPECT_DOUBLE_EQ(signedDistance(pointAt(0, 0, 0), pointAt(3e200, 4e200, 0)), 5e200);
}

}  // namespace
}  // namespace link_bounds

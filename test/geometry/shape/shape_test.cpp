// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of point shapes that can be told by heart, and poses that give no box.
#include "link_bounds/geometry/shape/shape.h"

#include <gtest/gtest.h>

#include <limits>

#include "testing/brute_force.h"
#include "testing/numbers.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::turned;

constexpr double kShapeTolerance = 1e-12;  // metres; what is written here as a closed form

Shape pointsShape(const std::vector<Eigen::Vector3f>& points,
                  const Eigen::Affine3d& link_from_shape = kIdentity) {
  return {std::make_shared<const PointSet>(points), Solid::kNone, Eigen::Vector3d::Zero(),
          link_from_shape};
}

/// The corners of a box of widths 2, 4 and 6.
std::vector<Eigen::Vector3f> brick() {
  std::vector<Eigen::Vector3f> result;
  for (int i = 0; i < 8; ++i) {
    result.emplace_back(i & 1 ? 1.0f : -1.0f, i & 2 ? 2.0f : -2.0f, i & 4 ? 3.0f : -3.0f);
  }
  return result;
}

void expectBox(const std::optional<Aabb>& box, const Eigen::Vector3d& min,
               const Eigen::Vector3d& max) {
  ASSERT_TRUE(box);
  EXPECT_LE((box->min() - min).cwiseAbs().maxCoeff(), kShapeTolerance) << box->min().transpose();
  EXPECT_LE((box->max() - max).cwiseAbs().maxCoeff(), kShapeTolerance) << box->max().transpose();
}

TEST(WorldBox, BrickTurnedBy30And45And90Degrees) {
  for (const double degrees : {30.0, 45.0, 90.0}) {
    SCOPED_TRACE(degrees);
    const double c = std::cos(degrees * M_PI / 180);
    const double s = std::sin(degrees * M_PI / 180);
    const Eigen::Affine3d pose(turned(degrees, Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d half(1 * c + 2 * s, 1 * s + 2 * c, 3);
    expectBox(worldBox(pointsShape(brick()), pose), -half, half);
  }
}

TEST(WorldBox, TheMinAndMaxCornerAloneWouldNotDo) {
  // At 45 degrees these two corners of a cube share their x: a box from them would be flat.
  std::vector<Eigen::Vector3f> cube = brick();
  for (Eigen::Vector3f& corner : cube)
    corner = corner.cwiseSign();
  const auto box =
      worldBox(pointsShape(cube), Eigen::Affine3d(turned(45, Eigen::Vector3d::UnitZ())));
  const Eigen::Vector3d half(std::sqrt(2.0), std::sqrt(2.0), 1);
  expectBox(box, -half, half);
}

TEST(WorldBox, ATriangleIsTighterThanItsTurnedBox) {
  const Eigen::Affine3d pose(turned(30, Eigen::Vector3d::UnitZ()));
  const auto box = worldBox(pointsShape({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}), pose);
  expectBox(box, {-1, 0, 0}, {std::sqrt(3.0), std::sqrt(3.0), 0});
}

TEST(WorldBox, OriginComesBeforeThePoseOfTheLink) {
  const Eigen::Affine3d world_from_link(turned(90, Eigen::Vector3d::UnitZ()));
  const Eigen::Affine3d link_from_shape(Eigen::Translation3d(10, 0, 0));
  expectBox(worldBox(pointsShape(brick(), link_from_shape), world_from_link), {-2, 9, -3},
            {2, 11, 3});
}

TEST(WorldBox, ScaleActsOnThePointsAndNotOnTheOrigin) {
  Eigen::Affine3d link_from_shape(Eigen::Translation3d(10, 0, 0));
  link_from_shape.scale(Eigen::Vector3d(0.5, -1, 0));
  expectBox(worldBox(pointsShape(brick(), link_from_shape), kIdentity), {9.5, -2, 0}, {10.5, 2, 0});
}

TEST(WorldBox, EqualPointsFollowTheTranslation) {
  const std::vector<Eigen::Vector3f> points(20, Eigen::Vector3f(0.5, 0.25, -0.125));
  for (const double t : {0.0, 1.0, -300.0}) {
    const Eigen::Vector3d at(t + 0.5, 2 * t + 0.25, 0.5 * t - 0.125);
    expectBox(worldBox(pointsShape(points), Eigen::Affine3d(Eigen::Translation3d(t, 2 * t, t / 2))),
              at, at);
  }
}

TEST(WorldBox, WithoutPointsAndSolidItIsTheOrigin) {
  expectBox(worldBox(Shape{}, Eigen::Affine3d(Eigen::Translation3d(1, 2, 3))), {1, 2, 3},
            {1, 2, 3});
}

TEST(WorldBox, NearlyEqualsBruteForceOnRandomPoses) {
  brute_force::Random random(1);
  const auto points = random.points(200, 0.5);
  for (int i = 0; i < repetitions(1000); ++i) {
    const Eigen::Affine3d pose = random.affine(2);
    const Aabb expected = brute_force::box(points, pose);
    expectBox(worldBox(pointsShape(points), pose), expected.min(), expected.max());
    expectBox(worldBox(pointsShape(points, pose), kIdentity), expected.min(), expected.max());
  }
}

TEST(WorldBox, NoBoxForAPoseThatIsNotUsable) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 2e30, -2e30}) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        Eigen::Affine3d pose = kIdentity;
        pose.linear()(row, column) = bad;
        EXPECT_FALSE(isUsablePose(pose)) << bad;
        EXPECT_FALSE(worldBox(pointsShape(brick()), pose)) << bad;
        EXPECT_FALSE(worldBox({nullptr, Solid::kBox, Eigen::Vector3d::Ones(), pose}, kIdentity));
      }
    }
  }
}

TEST(WorldBox, NoBoxForATranslationThatIsNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int k = 0; k < 3; ++k) {
      Eigen::Affine3d pose = kIdentity;
      pose.translation()[k] = bad;
      EXPECT_FALSE(isUsablePose(pose));
      EXPECT_FALSE(worldBox(pointsShape(brick()), pose));
    }
  }
}

TEST(WorldBox, TheLimitOfTheLinearPartStillGivesAFiniteBox) {
  Eigen::Affine3d pose = kIdentity;
  pose.linear().setConstant(1e30);
  const auto box = worldBox(pointsShape({{3e38f, 3e38f, 3e38f}, {-3e38f, 0, 0}}), pose);
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->min().allFinite() && box->max().allFinite());
  EXPECT_GE(box->max().x(), 9e68);
}

TEST(WorldBox, NoBoxThatWouldNotBeFinite) {
  Eigen::Affine3d pose = kIdentity;
  pose.translation().x() = std::numeric_limits<double>::max();
  EXPECT_FALSE(worldBox(pointsShape(brick()), pose));
  const Eigen::Vector3d huge = Eigen::Vector3d::Constant(1e300);
  EXPECT_FALSE(
      worldBox({nullptr, Solid::kBox, huge, kIdentity}, Eigen::Affine3d(Eigen::Scaling(1e20))));
}

}  // namespace
}  // namespace link_bounds

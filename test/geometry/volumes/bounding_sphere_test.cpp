// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounding spheres contain their link, and are as small as formulas and Welzl's algorithm say.
#include "link_bounds/geometry/volumes/bounding_sphere.h"

#include <gtest/gtest.h>

#include <limits>

#include "testing/sanitized.h"
#include "testing/smallest_sphere.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using brute_force::turned;

constexpr int kLinks = kIsSanitized ? 20 : 100;

/// Exact comparison: in long double, rounding cannot hide a point that is outside.
void expectContains(const BoundingSphere& sphere, const LongVector& point) {
  const LongVector offset = point - sphere.center.cast<long double>();
  EXPECT_LE(offset.norm(), static_cast<long double>(sphere.radius));
}

TEST(BoundingSphere, ContainsEveryPointWhereverTheLinkIs) {
  Random random(1);
  for (int i = 0; i < kLinks; ++i) {
    const BoundedLink link = randomLink(random);
    const auto sphere = boundingSphere(link);
    ASSERT_TRUE(sphere);
    const std::vector<LongVector> points = pointsOf(link);
    for (const Eigen::Isometry3d& pose : manyPoses(random)) {
      const auto here = placed(*sphere, pose);
      ASSERT_TRUE(here);
      for (const LongVector& point : points)
        expectContains(*here, moved(point, pose));
    }
    if (HasFailure()) return;
  }
}

TEST(BoundingSphere, OfPointsIsTheSmallest) {
  Random random(2);
  for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 8u, 30u, 300u, 3000u}) {
    for (int i = 0; i < 10; ++i)
      expectSmallest(random.points(count, random.magnitude(-3, 3), random.vector(1)));
  }
}

TEST(BoundingSphere, OfFlatAndStraightSetsIsTheSmallest) {
  Random random(3);
  for (const Eigen::Vector3f& scale : {Eigen::Vector3f(1, 1, 0), Eigen::Vector3f(0, 1, 0)}) {
    auto points = random.points(50, 1);
    for (Eigen::Vector3f& point : points)
      point = turned(30, {1, 2, 3}).cast<float>() * point.cwiseProduct(scale);
    expectSmallest(points);
  }
}

TEST(BoundingSphere, OfPointsOnOneSphereIsTheSmallest) {
  Random random(4);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 500; ++i)
    points.push_back(random.vector(1).normalized().cast<float>() + Eigen::Vector3f(3, 0, 0));
  expectSmallest(points);
}

TEST(BoundingSphere, OfPointsInDouble) {
  Eigen::Matrix3Xd points(3, 5);
  points << 0.1, 6.1, 0.1, 0.2, 0.3,  //
      0.2, 0.2, 8.2, 0.3, 0.4,        //
      0.3, 0.3, 0.3, 0.4, 5.3;
  const auto owner = std::make_shared<const Eigen::Matrix3Xd>(points);
  const std::shared_ptr<const double> xyz(owner, owner->data());
  const Shape shape{std::make_shared<const PointSet>(xyz, 5), Solid::kNone, Eigen::Vector3d::Zero(),
                    Eigen::Affine3d::Identity()};
  std::vector<LongVector> exact;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    exact.emplace_back(points.col(i).cast<long double>());
  const auto smallest = brute_force::smallestSphere(exact);
  expectSphere(linkOf({shape}), smallest.center.cast<double>(),
               static_cast<double>(smallest.radius));
}

TEST(BoundingSphere, OfSolids) {
  Random random(5);
  for (const double degrees : {0.0, 30.0, 45.0}) {
    Eigen::Affine3d pose(turned(degrees, {1, 2, 3}));
    const Eigen::Vector3d center(1, -2, 3);
    pose.pretranslate(center);
    expectSphere(linkOf({solidShape(Solid::kBox, {2, 4, 4}, pose)}), center, 3);
    expectSphere(linkOf({solidShape(Solid::kEllipsoid, {1, 1, 1}, pose)}), center, 0.5);
    expectSphere(linkOf({solidShape(Solid::kEllipsoid, {1, 4, 2}, pose)}), center, 2);
    expectSphere(linkOf({solidShape(Solid::kCylinder, {6, 6, 8}, pose)}), center, 5);
    expectSphere(linkOf({solidShape(Solid::kCylinder, {8, 8, 0}, pose)}), center, 4);
    expectSphere(linkOf({solidShape(Solid::kBox, {0, 0, 0}, pose)}), center, 0);
  }
}

TEST(BoundingSphere, OfAShearedBallHasItsLongestHalfAxis) {
  Random random(6);
  for (int i = 0; i < kLinks; ++i) {
    const Eigen::Affine3d pose = random.affine(1);
    const double longest = pose.linear().jacobiSvd().singularValues()[0];
    expectSphere(linkOf({solidShape(Solid::kEllipsoid, {2, 2, 2}, pose)}), pose.translation(),
                 longest);
  }
}

TEST(BoundingSphere, OfTwoBallsTouchesBothFromOutside) {
  const Eigen::Affine3d there(Eigen::Translation3d(0, 5, 0));
  const BoundedLink link = linkOf(
      {solidShape(Solid::kEllipsoid, {2, 2, 2}), solidShape(Solid::kEllipsoid, {4, 4, 4}, there)});
  expectSphere(link, {0, 3, 0}, 4);
}

TEST(BoundingSphere, OfPointsSweptByABall) {
  Shape shape = meshShape({{0, 0, 0}, {6, 0, 0}, {0, 8, 0}});
  shape.solid = Solid::kEllipsoid;
  shape.size = {1, 1, 1};
  expectSphere(linkOf({shape}), {3, 4, 0}, 5.5);
}

/// The smallest sphere around samples of the link is no larger than that around the link.
TEST(BoundingSphere, OfAnyLinkIsTheSmallest) {
  Random random(7);
  const double loss = 2 * samplingLoss(kLinkSteps);  // two angles are sampled
  for (int i = 0; i < kLinks; ++i) {
    const BoundedLink link = randomLink(random);
    const auto sphere = boundingSphere(link);
    ASSERT_TRUE(sphere);
    const auto lower = brute_force::smallestSphere(pointsOf(link));
    EXPECT_LE(sphere->radius, static_cast<double>(lower.radius) * (1 + loss + kTolerance));
  }
}

TEST(BoundingSphere, IsPaddedOnEverySide) {
  BoundedLink link = linkOf({solidShape(Solid::kEllipsoid, {2, 2, 2})});
  link.padding = 0.25;
  expectSphere(link, {0, 0, 0}, 1.25);
}

TEST(BoundingSphere, OfNumbersNearTheEndsOfTheRange) {
  for (const double size : {1e-300, 1e-160, 1e160, 1e300})
    expectSphere(linkOf({solidShape(Solid::kCylinder, {6 * size, 6 * size, 8 * size})}), {0, 0, 0},
                 5 * size);
}

TEST(BoundingSphere, ThereIsNoneWithoutABox) {
  EXPECT_FALSE(boundingSphere(linkOf({})));
  Eigen::Affine3d unusable = Eigen::Affine3d::Identity();
  unusable.linear()(0, 0) = 2e30;
  EXPECT_FALSE(boundingSphere(linkOf({solidShape(Solid::kBox, {1, 1, 1}, unusable)})));
}

TEST(PlacedSphere, KeepsItsRadiusAndMovesItsCenter) {
  const Eigen::Isometry3d pose = posed(turned(30, Eigen::Vector3d::UnitZ()), {1, 2, 3});
  const auto sphere = placed({{2, 0, 0}, 0.5}, pose);
  ASSERT_TRUE(sphere);
  EXPECT_LE((sphere->center - Eigen::Vector3d(1 + std::sqrt(3), 3, 3)).norm(), kRounding);
  EXPECT_GE(sphere->radius, 0.5);
  EXPECT_LE(sphere->radius, 0.5 + kRounding);
}

TEST(PlacedSphere, ContainsItselfFarFromTheOrigin) {
  Random random(9);
  const BoundingSphere sphere{{1, 2, 3}, 1.5};
  for (int i = 0; i < kLinks; ++i) {
    const Eigen::Isometry3d pose = posed(random.rotation(), random.vector(1e6));
    const auto here = placed(sphere, pose);
    ASSERT_TRUE(here);
    for (int k = 0; k < 3; ++k) {
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d point =
            sphere.center + side * sphere.radius * Eigen::Vector3d::Unit(k);
        expectContains(*here, moved(point.cast<long double>(), pose));
      }
    }
  }
}

TEST(PlacedSphere, ContainsWhatAPoseThatIsNotRigidStretches) {
  Random random(8);
  const BoundingSphere sphere{{1, 2, 3}, 1.5};
  for (int i = 0; i < kLinks; ++i) {
    const Eigen::Isometry3d pose(random.affine(1).matrix());
    const auto here = placed(sphere, pose);
    ASSERT_TRUE(here);
    for (const Eigen::Vector3d& sample : surface(Solid::kEllipsoid, kLinkSteps))
      expectContains(*here, moved((sphere.center + 3 * sample).cast<long double>(), pose));
  }
}

TEST(PlacedSphere, ThereIsNoneWhereThePoseIsNotFinite) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(placed(BoundingSphere{{0, 0, 0}, 1}, pose));
  pose = Eigen::Isometry3d::Identity();
  pose.linear()(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(placed(BoundingSphere{{0, 0, 0}, 1}, pose));
}

}  // namespace
}  // namespace link_bounds

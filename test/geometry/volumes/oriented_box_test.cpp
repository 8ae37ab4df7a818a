// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Oriented boxes contain their link, are never larger than the box at rest, and are as good as the
// best of a long search.
#include "link_bounds/geometry/volumes/oriented_box.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "testing/sampled_links.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using brute_force::turned;

constexpr double kTolerance = 1e-6;  // of a volume or a width
constexpr double kRounding = 1e-12;  // metres
constexpr int kRandomLinks = kIsSanitized ? 5 : 30;
const Eigen::Isometry3d kUnmoved = Eigen::Isometry3d::Identity();

/// Exact comparison: in long double, rounding cannot hide a point that is outside.
void expectContains(const OrientedBox& box, const std::vector<LongVector>& points,
                    const Eigen::Isometry3d& pose) {
  const Eigen::Quaternion<long double> orientation =
      box.orientation.cast<long double>().normalized();
  const LongMatrix box_from_world = orientation.toRotationMatrix().transpose();
  const LongVector half = box.size.cast<long double>() / 2;
  for (const LongVector& point : points) {
    const LongVector inside =
        box_from_world * (moved(point, pose) - box.center.cast<long double>());
    ASSERT_TRUE((inside.cwiseAbs().array() <= half.array()).all());
  }
}

std::vector<Eigen::Vector3f> boxCorners(const Eigen::Vector3d& size,
                                        const Eigen::Matrix3d& rotation) {
  std::vector<Eigen::Vector3f> result;
  for (const Eigen::Vector3d& corner : surface(Solid::kBox, 0))
    result.push_back((rotation * corner.cwiseProduct(size)).cast<float>());
  return result;
}

Eigen::Vector3d sortedWidths(const OrientedBox& box) {
  Eigen::Vector3d widths = box.size;
  std::sort(widths.data(), widths.data() + 3);
  return widths;
}

double volumeAtRest(const BoundedLink& link) {
  return linkBox(link, Eigen::Affine3d::Identity())->volume();
}

TEST(OrientedBox, ContainsEveryPointWhereverTheLinkIs) {
  Random random(1);
  for (int i = 0; i < kRandomLinks; ++i) {
    BoundedLink link = randomLink(random);
    const auto box = orientedBox(link);
    ASSERT_TRUE(box);
    const std::vector<LongVector> points = pointsOf(link);
    expectContains(*box, points, kUnmoved);
    for (const Eigen::Isometry3d& pose : manyPoses(random)) {
      const auto here = placed(*box, pose);
      ASSERT_TRUE(here);
      expectContains(*here, points, pose);
    }
    if (HasFailure()) return;
  }
}

TEST(OrientedBox, ContainsATurnedSolidFarFromTheFrameOfItsLink) {
  Random random(9);
  for (int i = 0; i < 10 * kRandomLinks; ++i) {
    Eigen::Affine3d pose(random.rotation());
    pose.pretranslate(random.vector(1e6));
    const BoundedLink link = linkOf({solidShape(Solid::kBox, {1, 2, 3}, pose)});
    expectContains(*orientedBox(link), pointsOf(link), kUnmoved);
  }
}

TEST(OrientedBox, IsNeverLargerThanTheBoxAtRest) {
  Random random(2);
  double mean = 0;
  for (int i = 0; i < kRandomLinks; ++i) {
    const BoundedLink link = randomLink(random);
    const double ratio = orientedBox(link)->size.prod() / volumeAtRest(link);
    EXPECT_LE(ratio, 1 + kRounding);
    mean += ratio / kRandomLinks;
  }
  EXPECT_LT(mean, 0.9);
}

TEST(OrientedBox, FindsATurnedBoxFromItsCornersAlone) {
  const Eigen::Vector3d size(0.2, 0.5, 0.9);
  Random random(3);
  std::vector<Eigen::Matrix3d> rotations{turned(30, Eigen::Vector3d::UnitZ()),
                                         turned(45, Eigen::Vector3d(1, 1, 0)),
                                         turned(45, Eigen::Vector3d::UnitX())};
  for (int i = 0; i < kRandomLinks; ++i)
    rotations.push_back(random.rotation());
  for (const Eigen::Matrix3d& rotation : rotations) {
    const auto box = orientedBox(linkOf({meshShape(boxCorners(size, rotation))}));
    ASSERT_TRUE(box);
    EXPECT_LE((sortedWidths(*box) - size).cwiseAbs().maxCoeff(), kTolerance);
  }
}

TEST(OrientedBox, FindsThinPlatesAndRods) {
  Random random(4);
  for (const Eigen::Vector3d& size : {Eigen::Vector3d(1e-4, 1, 1.5), Eigen::Vector3d(1e-3, 1e-3, 1),
                                      Eigen::Vector3d(1e-3, 0.03, 1)}) {
    for (int i = 0; i < 5; ++i) {
      const auto box = orientedBox(linkOf({meshShape(boxCorners(size, random.rotation()))}));
      ASSERT_TRUE(box);
      EXPECT_LE((sortedWidths(*box) - size).cwiseAbs().maxCoeff(), kTolerance);
    }
  }
}

TEST(OrientedBox, OfATurnedSolidHasItsAxes) {
  for (const double degrees : {30.0, 45.0}) {
    Eigen::Affine3d pose(turned(degrees, {1, 2, 3}));
    pose.pretranslate(Eigen::Vector3d(1, -2, 3));
    for (const Solid solid : {Solid::kBox, Solid::kCylinder}) {
      const auto box = orientedBox(linkOf({solidShape(solid, {0.5, 0.5, 2}, pose)}));
      ASSERT_TRUE(box);
      EXPECT_LE((sortedWidths(*box) - Eigen::Vector3d(0.5, 0.5, 2)).cwiseAbs().maxCoeff(),
                kRounding);
      EXPECT_LE((box->center - pose.translation()).norm(), kRounding);
    }
  }
}

/// The edges of the tetrahedron are face diagonals of the cube.
TEST(OrientedBox, OfATetrahedronIsTheCubeAroundIt) {
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                   Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)})
    points.push_back((turned(30, {1, 2, 3}) * p).cast<float>());
  const auto box = orientedBox(linkOf({meshShape(points)}));
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->size.prod(), 8, 8 * 1e-5);
}

/// With few points there are many local minima.
TEST(OrientedBox, IsAsGoodAsALongSearchAtRandom) {
  Random random(5);
  for (int i = 0; i < kRandomLinks; ++i) {
    const BoundedLink link = linkOf({meshShape(random.points(6, 1))});
    double best = volumeAtRest(link);
    for (int k = 0; k < 5000; ++k)
      best = std::min(best, linkBox(link, Eigen::Affine3d(random.rotation()))->volume());
    EXPECT_LE(orientedBox(link)->size.prod(), best * 1.01);
  }
}

TEST(OrientedBox, StaysUnturnedWhereTurningGainsNothing) {
  const auto box = orientedBox(linkOf({solidShape(Solid::kBox, {1, 2, 3})}));
  ASSERT_TRUE(box);
  EXPECT_EQ(box->orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_LE((box->size - Eigen::Vector3d(1, 2, 3)).cwiseAbs().maxCoeff(), kRounding);
  const auto ball = orientedBox(linkOf({solidShape(Solid::kEllipsoid, {1, 1, 1})}));
  EXPECT_EQ(ball->orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

TEST(OrientedBox, OfAPointALineAndAPlane) {
  const Eigen::Matrix3d rotation = turned(30, {1, 2, 3});
  const auto widths = [&](const Eigen::Vector3d& size) {
    return sortedWidths(*orientedBox(linkOf({meshShape(boxCorners(size, rotation))})));
  };
  EXPECT_LE(widths({0, 0, 0}).norm(), kRounding);
  EXPECT_LE((widths({0, 0, 2}) - Eigen::Vector3d(0, 0, 2)).norm(), kTolerance);
  EXPECT_LE((widths({0, 1, 2}) - Eigen::Vector3d(0, 1, 2)).norm(), kTolerance);
}

TEST(OrientedBox, OfAPlateTurnedInItsPlane) {
  const auto box =
      orientedBox(linkOf({meshShape(boxCorners({1, 3, 0}, turned(30, Eigen::Vector3d::UnitZ())))}));
  EXPECT_LE((sortedWidths(*box) - Eigen::Vector3d(0, 1, 3)).norm(), kTolerance);
}

/// What is added against rounding depends on the orientation. It must not decide which is best.
TEST(OrientedBox, OfAFlatLinkHasTheLeastArea) {
  Random random(10);
  for (const Eigen::Vector3d& size :
       {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, 3, 0), Eigen::Vector3d(1, 1, 1e-12)}) {
    for (const double degrees : {5.0, 30.0, 45.0, 60.0, 89.0}) {
      for (const Eigen::Matrix3d& tilt :
           {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), turned(90, {1, 0, 0}),
            turned(45, {1, 2, 0}), random.rotation()}) {
        for (const double offset : {0.0, 10.0}) {
          Eigen::Affine3d pose(tilt * turned(degrees, Eigen::Vector3d::UnitZ()));
          pose.pretranslate(random.vector(offset));
          const auto box = orientedBox(linkOf({solidShape(Solid::kBox, size, pose)}));
          const auto mesh =
              orientedBox(linkOf({meshShape(boxCorners(size, Eigen::Matrix3d::Identity()), pose)}));
          for (const auto& found : {box, mesh}) {
            ASSERT_TRUE(found);
            const Eigen::Vector3d widths = sortedWidths(*found);
            EXPECT_LE(widths[1] * widths[2], size.x() * size.y() * (1 + kTolerance))
                << degrees << " degrees, " << offset << " m away";
            EXPECT_LE(widths[0], 1e-8);
          }
        }
      }
    }
  }
}

TEST(OrientedBox, OfAStraightLinkIsNoLongerThanTheLink) {
  Random random(11);
  for (int i = 0; i < 5; ++i) {
    const auto box = orientedBox(
        linkOf({solidShape(Solid::kBox, {0, 0, 2}, Eigen::Affine3d(random.rotation()))}));
    ASSERT_TRUE(box);
    EXPECT_LE((sortedWidths(*box) - Eigen::Vector3d(0, 0, 2)).norm(), kTolerance);
  }
}

TEST(OrientedBox, IsPaddedOnEverySide) {
  BoundedLink link = linkOf(
      {solidShape(Solid::kBox, {1, 2, 3}, Eigen::Affine3d(turned(30, Eigen::Vector3d::UnitX())))});
  link.padding = 0.25;
  EXPECT_LE((sortedWidths(*orientedBox(link)) - Eigen::Vector3d(1.5, 2.5, 3.5)).norm(), kRounding);
}

TEST(OrientedBox, IsTheSameEachTime) {
  Random random(6);
  const BoundedLink link = randomLink(random);
  const auto first = orientedBox(link);
  const auto second = orientedBox(link);
  EXPECT_EQ(first->center, second->center);
  EXPECT_EQ(first->size, second->size);
  EXPECT_EQ(first->orientation.coeffs(), second->orientation.coeffs());
}

TEST(OrientedBox, OfNumbersNearTheEndsOfTheRange) {
  const Eigen::Affine3d pose(turned(30, Eigen::Vector3d::UnitX()));
  for (const double size : {1e-250, 1e-90, 1e90, 1e250}) {
    const BoundedLink link =
        linkOf({solidShape(Solid::kBox, size * Eigen::Vector3d(1, 2, 3), pose)});
    const auto box = orientedBox(link);
    ASSERT_TRUE(box);
    expectContains(*box, pointsOf(link), kUnmoved);
  }
}

/// Rounding alone makes some turns better than others.
TEST(OrientedBox, OfATiltedRodIsFoundInTime) {
  Random random(12);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d along = random.vector(3);
    std::vector<Eigen::Vector3f> points;
    for (int point = 0; point < 33; ++point)
      points.push_back((random.uniform(-1, 1) * along).cast<float>());
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(orientedBox(linkOf({meshShape(points)})));
    EXPECT_LT(std::chrono::steady_clock::now() - start,
              std::chrono::seconds(kIsSanitized ? 60 : 5));
  }
}

TEST(OrientedBox, ThereIsNoneWithoutABox) {
  EXPECT_FALSE(orientedBox(linkOf({})));
  Eigen::Affine3d unusable = Eigen::Affine3d::Identity();
  unusable.linear()(0, 0) = 2e30;
  EXPECT_FALSE(orientedBox(linkOf({solidShape(Solid::kBox, {1, 1, 1}, unusable)})));
}

TEST(PlacedOrientedBox, TurnsWithTheLinkAndKeepsItsSize) {
  const Eigen::Quaterniond orientation(turned(45, {1, 2, 3}));
  const Eigen::Isometry3d pose = posed(turned(30, Eigen::Vector3d::UnitZ()), {1, 2, 3});
  const auto box = placed(OrientedBox{{2, 0, 0}, orientation, {1, 2, 3}}, pose);
  ASSERT_TRUE(box);
  EXPECT_LE((box->center - Eigen::Vector3d(1 + std::sqrt(3), 3, 3)).norm(), kRounding);
  EXPECT_TRUE(box->orientation.toRotationMatrix().isApprox(
      pose.linear() * orientation.toRotationMatrix(), kRounding));
  EXPECT_LE((box->size - Eigen::Vector3d(1, 2, 3)).norm(), kRounding);
}

TEST(PlacedOrientedBox, ContainsItselfFarFromTheOrigin) {
  Random random(8);
  const OrientedBox box{{1, 2, 3}, Eigen::Quaterniond::Identity(), {0.5, 1, 2}};
  std::vector<LongVector> points;
  for (const Eigen::Vector3d& corner : surface(Solid::kBox, 0))
    points.emplace_back((box.center + corner.cwiseProduct(box.size)).cast<long double>());
  for (int i = 0; i < kRandomLinks; ++i) {
    const Eigen::Isometry3d pose = posed(random.rotation(), random.vector(1e6));
    const auto here = placed(box, pose);
    ASSERT_TRUE(here);
    expectContains(*here, points, pose);
  }
}

TEST(PlacedOrientedBox, ContainsWhatAPoseThatIsNotRigidStretches) {
  Random random(7);
  const BoundedLink link = linkOf({solidShape(Solid::kBox, {1, 2, 3})});
  const auto box = orientedBox(link);
  for (int i = 0; i < kRandomLinks; ++i) {
    const Eigen::Isometry3d pose(random.affine(1).matrix());
    const auto here = placed(*box, pose);
    ASSERT_TRUE(here);
    expectContains(*here, pointsOf(link), pose);
  }
}

TEST(PlacedOrientedBox, ThereIsNoneWhereThePoseIsNotFinite) {
  const OrientedBox box{{0, 0, 0}, Eigen::Quaterniond::Identity(), {1, 1, 1}};
  Eigen::Isometry3d pose = kUnmoved;
  pose.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(placed(box, pose));
  pose = kUnmoved;
  pose.linear()(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(placed(box, pose));
}

}  // namespace
}  // namespace link_bounds

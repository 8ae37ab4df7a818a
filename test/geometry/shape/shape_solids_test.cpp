// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of solids against closed forms and against dense samples of their surface.
#include <gtest/gtest.h>

#include "link_bounds/geometry/shape/shape.h"
#include "testing/brute_force.h"
#include "testing/numbers.h"
#include "testing/solid_samples.h"

namespace link_bounds {
namespace {

using brute_force::turned;

constexpr double kSolidTolerance = 1e-12;  // metres, for closed forms
constexpr int kSteps = 720;                // samples around a circle
const double kSamplingLoss = samplingLoss(kSteps);
const Eigen::Vector3d kSize(0.4, 0.6, 1.0);

Shape solidShape(Solid solid, const Eigen::Vector3d& size) {
  return {nullptr, solid, size, kIdentity};
}

void expectHalves(const Shape& shape, const Eigen::Matrix3d& rotation,
                  const Eigen::Vector3d& half) {
  const Eigen::Vector3d center(1, -2, 3);
  Eigen::Affine3d pose(rotation);
  pose.pretranslate(center);
  const auto box = worldBox(shape, pose);
  ASSERT_TRUE(box);
  EXPECT_LE((box->max() - (center + half)).cwiseAbs().maxCoeff(), kSolidTolerance);
  EXPECT_LE((box->min() - (center - half)).cwiseAbs().maxCoeff(), kSolidTolerance);
}

/// Calls check(cos, sin, degrees) for angles that matter.
template <class Check>
void forAngles(const Check& check) {
  for (const double degrees : {0.0, 30.0, 45.0, 60.0, 90.0}) {
    SCOPED_TRACE(degrees);
    check(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180), degrees);
  }
}

TEST(Solids, BoxTurnedAboutEachAxis) {
  const Eigen::Vector3d h = kSize / 2;
  const Shape shape = solidShape(Solid::kBox, kSize);
  forAngles([&](double c, double s, double degrees) {
    expectHalves(shape, turned(degrees, Eigen::Vector3d::UnitX()),
                 {h.x(), c * h.y() + s * h.z(), s * h.y() + c * h.z()});
    expectHalves(shape, turned(degrees, Eigen::Vector3d::UnitY()),
                 {c * h.x() + s * h.z(), h.y(), s * h.x() + c * h.z()});
    expectHalves(shape, turned(degrees, Eigen::Vector3d::UnitZ()),
                 {c * h.x() + s * h.y(), s * h.x() + c * h.y(), h.z()});
  });
}

TEST(Solids, CylinderTurnedAboutEachAxis) {
  const double radius = 0.2;
  const double half_length = 0.5;
  const Shape shape = solidShape(Solid::kCylinder, {2 * radius, 2 * radius, 2 * half_length});
  forAngles([&](double c, double s, double degrees) {
    const double across = radius * c + half_length * s;
    const double along = radius * s + half_length * c;
    expectHalves(shape, turned(degrees, Eigen::Vector3d::UnitX()), {radius, across, along});
    expectHalves(shape, turned(degrees, Eigen::Vector3d::UnitY()), {across, radius, along});
    expectHalves(shape, turned(degrees, Eigen::Vector3d::UnitZ()), {radius, radius, half_length});
  });
}

TEST(Solids, SphereDoesNotNoticeRotation) {
  brute_force::Random random(1);
  const Shape shape = solidShape(Solid::kEllipsoid, Eigen::Vector3d::Constant(0.5));
  forAngles([&](double, double, double degrees) {
    expectHalves(shape, turned(degrees, Eigen::Vector3d(1, 2, 3)), Eigen::Vector3d::Constant(0.25));
  });
  for (int i = 0; i < 200; ++i) {
    expectHalves(shape, random.rotation(), Eigen::Vector3d::Constant(0.25));
  }
}

TEST(Solids, EllipsoidTurnedAboutZ) {
  const Eigen::Vector3d h = kSize / 2;
  forAngles([&](double c, double s, double degrees) {
    expectHalves(solidShape(Solid::kEllipsoid, kSize), turned(degrees, Eigen::Vector3d::UnitZ()),
                 {std::hypot(c * h.x(), s * h.y()), std::hypot(s * h.x(), c * h.y()), h.z()});
  });
}

/// The box of surface samples around each of `points`, under a pose.
Aabb sampledBox(Solid solid, const std::vector<Eigen::Vector3f>& points,
                const Eigen::Affine3d& pose) {
  Aabb around_origin;
  const Eigen::Matrix3d linear = pose.linear() * kSize.asDiagonal();
  for (const Eigen::Vector3d& sample : surface(solid, kSteps))
    around_origin.extend(linear * sample);
  Aabb result;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d center = pose * point.cast<double>();
    result.extend((center + around_origin.min()).eval());
    result.extend((center + around_origin.max()).eval());
  }
  return result;
}

/// `box` covers the samples, and reaches beyond them no farther than samples can be missing.
void expectFits(const std::optional<Aabb>& box, const Aabb& samples,
                const Eigen::Matrix3d& linear) {
  ASSERT_TRUE(box);
  EXPECT_TRUE(padded(*box, kSolidTolerance).contains(samples));
  for (int k = 0; k < 3; ++k) {
    // Two angles are sampled, hence the factor.
    const double loss = 2 * kSamplingLoss * (linear.row(k) * kSize.asDiagonal()).norm();
    EXPECT_LE(samples.min()[k] - box->min()[k], loss + kSolidTolerance);
    EXPECT_LE(box->max()[k] - samples.max()[k], loss + kSolidTolerance);
  }
}

class SampledSolids : public testing::TestWithParam<Solid> {};

TEST_P(SampledSolids, UnderRotation) {
  brute_force::Random random(2);
  for (int i = 0; i < 30; ++i) {
    const Eigen::Affine3d pose = random.rigid(3);
    expectFits(worldBox(solidShape(GetParam(), kSize), pose),
               sampledBox(GetParam(), {Eigen::Vector3f::Zero()}, pose), pose.linear());
  }
}

TEST_P(SampledSolids, UnderShearMirrorAndUnevenScale) {
  brute_force::Random random(3);
  for (int i = 0; i < 30; ++i) {
    const Eigen::Affine3d pose = random.affine(3);
    expectFits(worldBox(solidShape(GetParam(), kSize), pose),
               sampledBox(GetParam(), {Eigen::Vector3f::Zero()}, pose), pose.linear());
  }
}

TEST_P(SampledSolids, SweptAlongPoints) {
  brute_force::Random random(4);
  for (int i = 0; i < 20; ++i) {
    const auto points = random.points(20, 1);
    const Eigen::Affine3d pose = random.affine(3);
    const Shape shape{std::make_shared<const PointSet>(points), GetParam(), kSize, pose};
    expectFits(worldBox(shape, kIdentity), sampledBox(GetParam(), points, pose), pose.linear());
  }
}

TEST_P(SampledSolids, FlattenedToAPlane) {
  Eigen::Affine3d pose(turned(30, Eigen::Vector3d(1, 1, 0)));
  pose.linear() *= Eigen::Vector3d(1, 0, 2).asDiagonal();
  expectFits(worldBox(solidShape(GetParam(), kSize), pose),
             sampledBox(GetParam(), {Eigen::Vector3f::Zero()}, pose), pose.linear());
}

INSTANTIATE_TEST_SUITE_P(Shape, SampledSolids,
                         testing::Values(Solid::kBox, Solid::kEllipsoid, Solid::kCylinder));

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Solids with a tip: a disc with one is a cone.
#include <gtest/gtest.h>

#include "link_bounds/geometry/distance/body_distance.h"
#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using distance_oracle::Long;

Body withTip(Solid solid, const Eigen::Vector3d& size, const Eigen::Vector3d& tip,
             const Eigen::Affine3d& link_from_shape = kIdentity) {
  return {{{{nullptr, solid, size, link_from_shape}, nullptr, tip}}};
}

/// Cones: upright, oblique, mirrored, with the tip in the disc, in its rim and nearly in it, of no
/// radius; some with the tip on another solid. All but the last three have it off the plane z = 0.
Body anyCone(Random& random, int kind, const Eigen::Affine3d& link_from_shape = kIdentity) {
  const double radius = random.magnitude(-2, 0);
  Eigen::Vector3d size(2 * radius, 2 * radius, 0);
  Eigen::Vector3d tip(0, 0, random.sign() * random.magnitude(-2, 0));
  if (kind == 1) tip += random.vector(1);
  if (kind == 2) tip = random.vector(radius / 2).cwiseProduct(Eigen::Vector3d(1, 1, 0));
  if (kind == 3) tip = Eigen::Vector3d(radius, 0, 0);
  if (kind == 4) tip = Eigen::Vector3d(random.uniform(0, 2), 0, random.magnitude(-12, -6));
  if (kind == 5) size.setZero();
  if (kind == 6) size.z() = random.uniform(0, 1);
  const Solid others[] = {Solid::kBox, Solid::kEllipsoid, Solid::kNone};
  const Solid solid = kind > 6 ? others[kind - 7] : Solid::kCylinder;
  return withTip(solid, size, tip, link_from_shape);
}

constexpr int kConePoseKinds = 10;

TEST(ConeDistance, IsProvenByItsNormal) {
  Random random(1);
  for (int i = 0; i < repetitions(100000); ++i) {
    const Body cone =
        anyCone(random, i % kConePoseKinds, i % 3 ? random.rigid(0.3) : random.affine(0.3));
    const Solid kinds[] = {Solid::kBox, Solid::kEllipsoid, Solid::kCylinder};
    Body other = anyCone(random, i / kConePoseKinds % kConePoseKinds, random.rigid(0.3));
    if (i % 4 == 0) other = {{{{nullptr, kinds[i % 3], random.vector(1).cwiseAbs()}}}};
    const Eigen::Affine3d pose = random.rigid(1);
    Eigen::Affine3d of_other = random.rigid(0);
    of_other.translation() = random.vector(random.magnitude(-1, 0.5));
    const BodyDistance found = *bodyDistance(cone, pose, other, of_other);
    ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-12) << i;
    ASSERT_NEAR((found.on_second - found.on_first).norm(), found.upper, 1e-11);
    const BodyShape& a = cone.shapes[0];
    const BodyShape& b = other.shapes[0];
    // A point lies in its solid if no support along any direction is exceeded.
    for (int k = 0; k < 6; ++k) {
      Eigen::Vector3d d = random.vector(1).normalized();
      if (k == 0) d = (found.on_second - found.on_first).stableNormalized();
      ASSERT_LE(d.dot(found.on_first), solidSupport(a, pose, d) + 1e-12) << i;
      ASSERT_LE(-d.dot(found.on_second), solidSupport(b, of_other, -d) + 1e-12) << i;
    }
    if (found.lower == 0) continue;
    const Eigen::Vector3d& n = found.normal;
    const Long gap = -solidSupport(b, of_other, -n) - solidSupport(a, pose, n);
    ASSERT_GE(gap, found.lower * n.cast<Long>().norm()) << i;
  }
}

/// The surface of a cone of a disc and a tip, as a pyramid of `sides` that lies in the cone or,
/// with a larger radius, around it.
TriangleMesh pyramid(double radius, const Eigen::Vector3d& tip, std::uint32_t sides) {
  TriangleMesh mesh{{Eigen::Vector3f::Zero(), tip.cast<float>()}, {}};
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    mesh.vertices.push_back(
        (radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)).cast<float>());
    const std::uint32_t here = 2 + i, next = 2 + (i + 1) % sides;
    mesh.triangles.push_back({0, here, next});
    mesh.triangles.push_back({1, here, next});
  }
  return mesh;
}

bool isInCone(const Eigen::Vector3d& p, double radius, const Eigen::Vector3d& tip) {
  const double part = p.z() / tip.z();  // of the way to the tip
  return part >= 0 && part <= 1 && (p - part * tip).head<2>().norm() <= (1 - part) * radius;
}

TEST(ConeDistance, OfAConeAndAMeshIsThatOfPyramidsInAndAroundTheCone) {
  constexpr std::uint32_t kSides = 128;
  constexpr double kFloat = 1e-6;  // the pyramids are rounded to float
  Random random(2);
  for (int i = 0; i < repetitions(200); ++i) {
    const double radius = random.magnitude(-2, 0);
    Eigen::Vector3d tip(0, 0, random.sign() * random.magnitude(-2, 0));
    if (i % 2) tip.head<2>() = random.vector(1).head<2>();
    const Body cone = withTip(Solid::kCylinder, {2 * radius, 2 * radius, 0}, tip);
    MeshBody other;
    other.add(anyMesh(random, 0.3, 20));
    const Eigen::Affine3d pose = random.rigid(1), of_other = random.rigid(1);
    const auto triangles = other.placed(of_other);
    const auto to = [&](double pyramid_radius) {
      return distance_oracle::distance(
          distance_oracle::placed(pyramid(pyramid_radius, tip, kSides), kIdentity, pose),
          triangles);
    };
    Long longest = to(radius), shortest = to(radius / std::cos(M_PI / kSides));
    const Eigen::Affine3d cone_from_other = pose.inverse() * of_other;
    for (const Eigen::Vector3f& vertex : other.meshes[0].vertices) {
      if (isInCone(cone_from_other * vertex.cast<double>(), radius, tip)) longest = shortest = 0;
    }
    const BodyDistance found = i % 3 ? *bodyDistance(cone, pose, other.body, of_other)
                                     : *bodyDistance(other.body, of_other, cone, pose);
    ASSERT_LE(found.lower, longest + kFloat) << i;
    ASSERT_GE(found.upper, shortest - kFloat) << i;
    ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-12) << i;
  }
}

TEST(ConeDistance, IsProvenWhereTheTipIsFarAway) {
  // Rounding grows with the distance of the tip, also for what is near the disc.
  Random random(3);
  const Body ball{{{{nullptr, Solid::kEllipsoid, {0.1, 0.1, 0.1}}}}};
  for (int i = 0; i < repetitions(2000); ++i) {
    const Eigen::Vector3d tip = random.vector(1e6);
    const Body cone = withTip(Solid::kCylinder, {0.1, 0.1, 0}, tip);
    const Eigen::Affine3d pose = random.rigid(1);
    const Eigen::Affine3d at_tip(Eigen::Translation3d(pose * (1e-6 * tip + random.vector(1))));
    const BodyDistance found = *bodyDistance(cone, pose, ball, at_tip);
    const Eigen::Vector3d& n = found.normal;
    const Long gap =
        -solidSupport(ball.shapes[0], at_tip, -n) - solidSupport(cone.shapes[0], pose, n);
    ASSERT_GE(gap, found.lower * n.cast<Long>().norm()) << i;
  }
}

TEST(ConeDistance, CountsTheTipInTheBoxes) {
  // Boxes alone decide these distances.
  const Body cone = withTip(Solid::kCylinder, {1, 1, 0}, {0, 0, 2});
  const Body cube{{{{nullptr, Solid::kBox, {1, 1, 1}}}}};
  const Eigen::Affine3d above(Eigen::Translation3d(0, 0, 5));
  const BodyDistance near = *bodyDistance(cone, kIdentity, cube, above);
  EXPECT_NEAR(near.upper, 2.5, 1e-9);
  EXPECT_NEAR(near.lower, 2.5, 1e-9);
  const BodyDistance far = *bodyDistance(cone, kIdentity, cube, above, {1e-4, 1});
  EXPECT_EQ(far.level, DistanceLevel::kBox);
  EXPECT_NEAR(far.lower, 2.5, 1e-9);
}

TEST(ConeDistance, IsNothingForATipThatIsNotFinite) {
  const Body cube{{{{nullptr, Solid::kBox, {1, 1, 1}}}}};
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    const Body cone = withTip(Solid::kCylinder, {1, 1, 0}, {0, 0, bad});
    EXPECT_FALSE(bodyDistance(cone, kIdentity, cube, kIdentity)) << bad;
  }
}

}  // namespace
}  // namespace link_bounds

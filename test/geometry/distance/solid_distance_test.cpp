// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Solids, whose distances are known in closed form or bounded by their supports.
#include <gtest/gtest.h>

#include "link_bounds/geometry/distance/body_distance.h"
#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/quad.h"
#include "testing/sanitized.h"
#include "testing/solid_samples.h"

namespace link_bounds {
namespace {

using brute_force::Random;

Body solidBody(Solid solid, const Eigen::Vector3d& size,
               const Eigen::Affine3d& link_from_shape = kIdentity) {
  return {{{{nullptr, solid, size, link_from_shape}}}};
}

void expectDistance(const Body& a, const Eigen::Affine3d& pose, const Body& b,
                    const Eigen::Affine3d& other, double exact, double accuracy = 1e-4) {
  const BodyDistance found = *bodyDistance(a, pose, b, other, {accuracy});
  ASSERT_LE(found.lower, exact + 1e-15);  // the exact one is rounded
  ASSERT_GE(found.upper, exact - 1e-15);
  ASSERT_LE(found.upper - found.lower, accuracy + 1e-12) << exact;
  ASSERT_NE(found.level, DistanceLevel::kMesh);
}

TEST(SolidDistance, OfBalls) {
  Random random(1);
  for (int i = 0; i < repetitions(20000); ++i) {
    const double a = random.magnitude(-3, 0), b = random.magnitude(-3, 0);
    const Eigen::Affine3d pose = random.rigid(2), other = random.rigid(2);
    const double between = (pose.translation() - other.translation()).norm();
    expectDistance(solidBody(Solid::kEllipsoid, Eigen::Vector3d::Constant(2 * a)), pose,
                   solidBody(Solid::kEllipsoid, Eigen::Vector3d::Constant(2 * b)), other,
                   std::max(0.0, between - a - b));
  }
}

TEST(SolidDistance, OfBoxesOfEqualOrientation) {
  // FCL 0.7 is wrong by up to 0.58 m, on the side that is not safe.
  Random random(2);
  for (int i = 0; i < repetitions(20000); ++i) {
    const Eigen::Vector3d a = random.vector(1).cwiseAbs(), b = random.vector(1).cwiseAbs();
    const Eigen::Affine3d pose = i % 2 ? random.rigid(1) : kIdentity;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    for (int k = 0; k <= i % 4; ++k)
      offset[k % 3] = random.uniform(-3, 3);
    const Eigen::Vector3d gap = (offset.cwiseAbs() - (a + b) / 2).cwiseMax(0.0);
    expectDistance(solidBody(Solid::kBox, a), pose, solidBody(Solid::kBox, b),
                   pose * Eigen::Translation3d(offset), gap.norm());
  }
  const Body cube = solidBody(Solid::kBox, {1, 1, 1});
  expectDistance(cube, kIdentity, cube, Eigen::Affine3d(Eigen::Translation3d(3, 0, 0)), 2, 1e-9);
}

TEST(SolidDistance, OfABoxIsThatOfItsTrianglesOutside) {
  Random random(3);
  for (int i = 0; i < repetitions(5000); ++i) {
    const Eigen::Vector3d size = random.vector(1).cwiseAbs();
    MeshBody mesh, other;
    mesh.add(boxMesh(size));
    other.add(anyMesh(random, 0.3));
    const Eigen::Vector3d same = mesh.meshes[0].vertices[7].cast<double>() * 2;
    const Body solid = solidBody(Solid::kBox, same);
    const Eigen::Affine3d pose = random.rigid(1), pose_of_other = random.rigid(1);
    const auto triangles = other.placed(pose_of_other);
    auto exact = distance_oracle::distance(mesh.placed(pose), triangles);
    const Eigen::Affine3d box_from_other = pose.inverse() * pose_of_other;
    for (const Eigen::Vector3f& vertex : other.meshes[0].vertices) {
      const Eigen::Vector3d corner = box_from_other * vertex.cast<double>();
      if ((corner.cwiseAbs().array() <= same.array() / 2).all()) exact = 0;
    }
    const BodyDistance found = *bodyDistance(solid, pose, other.body, pose_of_other);
    ASSERT_LE(found.lower, exact);
    ASSERT_GE(found.upper, exact);
    ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-12);
  }
}

TEST(SolidDistance, OfABallIsThatOfItsCentreLessTheRadius) {
  Random random(4);
  for (int i = 0; i < repetitions(5000); ++i) {
    const double radius = random.magnitude(-3, 0);
    MeshBody mesh;
    mesh.add(anyMesh(random, 0.3));
    const Eigen::Affine3d pose = random.rigid(1), of_mesh = random.rigid(1);
    const auto exact = std::max<distance_oracle::Long>(
        0, distance_oracle::distance(pose.translation(), mesh.placed(of_mesh)) - radius);
    const Body ball = solidBody(Solid::kEllipsoid, Eigen::Vector3d::Constant(2 * radius));
    const BodyDistance found = *bodyDistance(mesh.body, of_mesh, ball, pose);
    ASSERT_LE(found.lower, exact + 1e-18L);
    ASSERT_GE(found.upper, exact - 1e-18L);
    ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-12);
  }
}

TEST(SolidDistance, OfPointsThatASolidSweeps) {
  // As a list of spheres: the triangles are points.
  Random random(5);
  for (int i = 0; i < repetitions(2000); ++i) {
    const double radius = random.magnitude(-2, -0.5);
    const auto points = random.points(20, 0.5);
    TriangleMesh spots{points, {}};
    std::vector<Eigen::Vector3d> centers;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      spots.triangles.push_back({k, k, k});
      centers.push_back(points[k].cast<double>());
    }
    const Eigen::Vector3d size = Eigen::Vector3d::Constant(2 * radius);
    const Shape shape{std::make_shared<const PointSet>(points), Solid::kEllipsoid, size, kIdentity};
    const Body balls{{{shape, triangleTree(centers, spots.triangles, Solid::kEllipsoid, size)}}};
    MeshBody mesh;
    mesh.add(anyMesh(random, 0.3));
    const Eigen::Affine3d pose = random.rigid(1), of_mesh = random.rigid(1);
    const auto exact = std::max<distance_oracle::Long>(
        0, distance_oracle::distance(distance_oracle::placed(spots, kIdentity, pose),
                                     mesh.placed(of_mesh)) -
               radius);
    const BodyDistance found = *bodyDistance(balls, pose, mesh.body, of_mesh);
    ASSERT_LE(found.lower, exact + 1e-18L);
    ASSERT_GE(found.upper, exact - 1e-18L);
    ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-12);
  }
}

TEST(SolidDistance, IsProvenByItsNormal) {
  Random random(6);
  const Solid kinds[] = {Solid::kBox, Solid::kEllipsoid, Solid::kCylinder};
  for (int i = 0; i < repetitions(100000); ++i) {
    const Body a = solidBody(kinds[i % 3], random.vector(1).cwiseAbs(), random.affine(0.3));
    const bool is_aligned = i % 5 == 0;
    const Body b = solidBody(kinds[i / 3 % 3], random.vector(1).cwiseAbs(),
                             is_aligned ? a.shapes[0].shape.link_from_shape : random.rigid(0.3));
    const Eigen::Affine3d pose = is_aligned ? kIdentity : random.rigid(3);
    Eigen::Affine3d other = is_aligned ? kIdentity : random.rigid(0);
    other.translation() = random.vector(random.magnitude(-1, 1));
    const BodyDistance found = *bodyDistance(a, pose, b, other);
    ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-12) << i;
    const Eigen::Vector3d& n = found.normal;
    if (found.lower == 0) continue;
    const auto gap = -solidSupport(b.shapes[0], other, -n) - solidSupport(a.shapes[0], pose, n);
    ASSERT_GE(gap, found.lower * n.cast<distance_oracle::Long>().norm());
    // A point lies in its solid if no support along any direction is exceeded.
    for (int k = 0; k < 5; ++k) {
      const Eigen::Vector3d d = random.vector(1).normalized();
      ASSERT_LE(d.dot(found.on_first), solidSupport(a.shapes[0], pose, d) + 1e-12);
      ASSERT_LE(d.dot(found.on_second), solidSupport(b.shapes[0], other, d) + 1e-12);
    }
  }
}

TEST(SolidDistance, OfSolidsOfNoSize) {
  const Body point = solidBody(Solid::kBox, Eigen::Vector3d::Zero());
  const Body disk = solidBody(Solid::kCylinder, {1, 1, 0});
  const Eigen::Affine3d above(Eigen::Translation3d(0.1, 0, 2));
  expectDistance(point, above, disk, kIdentity, 2, 1e-9);
  expectDistance(point, above, point, kIdentity, above.translation().norm(), 1e-9);
  expectDistance(point, above, point, above, 0, 1e-9);
}

}  // namespace
}  // namespace link_bounds

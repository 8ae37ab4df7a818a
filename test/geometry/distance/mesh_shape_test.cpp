// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes with vertices that no triangle uses, and meshes that a pose makes flat.
#include <gtest/gtest.h>

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/distance/body_distance.h"
#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

TEST(MeshShape, LeavesOutVerticesThatNoTriangleUses) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  const Eigen::Vector3f stray(3, 0, 0);
  mesh.vertices.insert(mesh.vertices.begin(), stray);
  mesh.vertices.push_back(stray);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& vertex : triangle)
      ++vertex;
  }
  const Body body{{*meshShape(mesh)}};
  const Body ball{{{{nullptr, Solid::kEllipsoid, {1, 1, 1}}}}};
  const BodyDistance found =
      *bodyDistance(body, kIdentity, ball, Eigen::Affine3d(Eigen::Translation3d(4, 0, 0)));
  EXPECT_GE(found.upper, 3);
  EXPECT_NEAR(found.lower, 3, 1e-4);
}

TEST(MeshShape, IsNothingWithoutAUsableTriangle) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.triangles[3][1] = 8;
  EXPECT_FALSE(meshShape(mesh));
  mesh.triangles.clear();
  EXPECT_FALSE(meshShape(mesh));
}

TEST(MeshShape, APointOfATreeIsAVertexThatATriangleUsesOrWhatSweepsIt) {
  // What builds without NDEBUG check.
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const TriangleMesh mesh = anyMesh(random, 0.3);
    std::vector<Eigen::Vector3d> vertices{random.vector(1)};
    for (const Eigen::Vector3f& vertex : mesh.vertices)
      vertices.push_back(vertex.cast<double>());
    auto triangles = mesh.triangles;
    for (auto& triangle : triangles) {
      for (std::uint32_t& vertex : triangle)
        ++vertex;
    }
    const Eigen::Vector3d size = random.vector(1e-3).cwiseAbs();
    const auto tree = triangleTree(vertices, triangles);
    const auto swept = triangleTree(vertices, triangles, Solid::kEllipsoid, size);
    const Eigen::Vector3d used = vertices[triangles.front()[0]];
    EXPECT_TRUE(holdsPoint(*tree, used));
    EXPECT_FALSE(holdsPoint(*tree, used + size / 3));
    EXPECT_TRUE(holdsPoint(*swept, used + farthestOf(Solid::kEllipsoid, size, random.vector(1))));
    EXPECT_FALSE(holdsPoint(*tree, vertices[0]));
    EXPECT_FALSE(holdsPoint(*swept, vertices[0]));
  }
}

/// How many pairs of nodes must be compared for the accuracy, up to a factor of 1.2.
double stepsNeeded(const Body& a, const Body& b, const Eigen::Affine3d& of_b) {
  constexpr double kAccuracy = 1e-4;
  for (double steps = 16;; steps *= 1.2) {
    const BodyDistance found = *bodyDistance(
        a, kIdentity, b, of_b, {kAccuracy, kInfinity, static_cast<std::size_t>(steps)});
    if (found.upper - found.lower <= kAccuracy + 1e-12 || steps > 1e7) return steps;
  }
}

TEST(MeshShape, ThatIsFlatTakesNoMoreStepsThanAThinOne) {
  const TriangleMesh ball = bumpyBall(24, 0.02);
  Random random(2);
  for (int axis = 0; axis < 3; ++axis) {
    double flat_steps = 0, thin_steps = 0;
    Eigen::Affine3d thin = kIdentity, flat = kIdentity;
    thin.linear()(axis, axis) = 1e-2;
    flat.linear()(axis, axis) = 0;
    const Body thin_body{{*meshShape(ball, thin)}}, flat_body{{*meshShape(ball, flat)}};
    for (int i = 0; i < (kIsSanitized ? 5 : 20); ++i) {
      Eigen::Affine3d pose = random.rigid(0.1);
      pose.translation() += 0.5 * random.vector(1).normalized();
      const double here = stepsNeeded(flat_body, flat_body, pose);
      flat_steps += here;
      thin_steps += stepsNeeded(thin_body, thin_body, pose);
    }
    EXPECT_LE(flat_steps, 2 * thin_steps) << axis;
  }
}

}  // namespace
}  // namespace link_bounds

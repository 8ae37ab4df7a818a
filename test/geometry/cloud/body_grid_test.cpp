// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels of points beside a comparison with every triangle in long double.
#include "geometry/cloud/body_grid.h"

#include <gtest/gtest.h>

#include "testing/distance_bodies.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using distance_oracle::Long;
using Triangles = std::vector<distance_oracle::Triangle>;

constexpr double kSlack = 1e-3;

// To make a grid of the default size takes most of the time under a sanitizer.
constexpr std::size_t kMaxBytes = (kIsSanitized ? 16 : 256) * 1024;

/// A tube around the z axis, closed in both directions.
TriangleMesh torus(double large, double small, std::uint32_t around, std::uint32_t across) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across;
      const double out = large + small * std::cos(b);
      mesh.vertices.push_back(
          Eigen::Vector3d(out * std::cos(a), out * std::sin(a), small * std::sin(b)).cast<float>());
      const std::uint32_t next_i = (i + 1) % around, next_j = (j + 1) % across;
      const std::array<std::uint32_t, 4> q{i * across + j, next_i * across + j,
                                           next_i * across + next_j, i * across + next_j};
      mesh.triangles.push_back({q[0], q[1], q[2]});
      mesh.triangles.push_back({q[0], q[2], q[3]});
    }
  }
  return mesh;
}

/// A triangle whose ball is farther than the best one so far is left out.
Long distanceOf(const Triangles& triangles, const Eigen::Vector3d& point) {
  Long best = std::numeric_limits<Long>::infinity();
  const distance_oracle::Vector p = point.cast<Long>();
  for (const auto& triangle : triangles) {
    const distance_oracle::Vector& a = triangle[0];
    const Long radius = std::max((triangle[1] - a).norm(), (triangle[2] - a).norm());
    if ((p - a).norm() - radius > best) continue;
    best = std::min(best, distance_oracle::distance<Long>(p, triangle));
  }
  return best;
}

/// By the solid angle of all triangles, which shares no rule with parity.
bool isInside(const Triangles& triangles, const Eigen::Vector3d& point) {
  Long angle = 0;
  for (const auto& triangle : triangles) {
    const distance_oracle::Vector p = point.cast<Long>(), a = triangle[0] - p, b = triangle[1] - p,
                                  c = triangle[2] - p;
    const Long la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(angle) > 2 * M_PI;
}

/// Points near the surface, and anywhere in the box and around it.
Eigen::Vector3d anyPoint(Random& random, const MeshBody& body, const Aabb& box, double padding) {
  if (random.uniform(0, 1) < 0.3) {
    const Eigen::Vector3d part(random.uniform(-0.1, 1.1), random.uniform(-0.1, 1.1),
                               random.uniform(-0.1, 1.1));
    return box.min() + part.cwiseProduct(box.sizes());
  }
  const TriangleMesh& mesh = body.meshes.front();
  const auto pick = static_cast<std::size_t>(
      random.uniform(0, static_cast<double>(mesh.triangles.size()) - 1e-9));
  double weight = 1;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = k == 2 ? weight : random.uniform(0, weight);
    weight -= part;
    point += part * mesh.vertices[mesh.triangles[pick][k]].cast<double>();
  }
  point = body.body.shapes.front().shape.link_from_shape * point;
  return point + random.uniform(0, 1.2 * (padding + kSlack)) * random.vector(1).normalized();
}

struct Counts {
  int body = 0, clear = 0, inside = 0;
};

/// Every label is that of the oracle. Points as near to the border as rounding are left out.
Counts compare(const MeshBody& body, double padding, bool is_closed, int points,
               std::uint64_t seed) {
  const BodyGrid grid(BodySurface(body.body), {padding, kSlack, kMaxBytes});
  EXPECT_LE(grid.bytes(), kMaxBytes);
  const Triangles triangles = body.placed(Eigen::Affine3d::Identity());
  Random random(seed);
  Counts counts;
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d point = anyPoint(random, body, grid.surface().box(), padding);
    const double slack = i % 2 == 0 ? 0 : random.uniform(0, kSlack);
    const Long distance = distanceOf(triangles, point);
    if (std::abs(distance - (padding + slack)) < 1e-12) continue;
    const bool is_near = distance < padding + slack;
    const bool is_inside = is_closed && !is_near && isInside(triangles, point);
    const bool expected = is_near || is_inside;
    EXPECT_EQ(grid.isBody(point, slack), expected)
        << point.transpose() << " at " << static_cast<double>(distance) << ", slack " << slack;
    counts.inside += is_inside;
    ++(expected ? counts.body : counts.clear);
  }
  return counts;
}

MeshBody bodyOf(const TriangleMesh& mesh,
                const Eigen::Affine3d& pose = Eigen::Affine3d::Identity()) {
  MeshBody body;
  body.add(mesh, pose);
  return body;
}

TEST(BodyGrid, LabelsPointsOfMeshesAsBruteForceDoes) {
  Random random(1);
  for (const double padding : {0.0, 0.001, 0.01, 0.05}) {
    const Counts ring =
        compare(bodyOf(torus(0.2, 0.06, 24, 12), random.rigid(0.3)), padding, true, 600, 2);
    EXPECT_GT(ring.body, 80);
    EXPECT_GT(ring.clear, 80);
    if (padding < 0.02) {
      EXPECT_GT(ring.inside, 2) << padding;
    }
    compare(bodyOf(boxMesh({0.3, 0.2, 0.1}), random.rigid(1)), padding, true, 600, 3);
    Eigen::Affine3d uneven = random.rigid(0.3);
    uneven.linear() *= Eigen::Vector3d(1, -0.5, 2).asDiagonal();
    compare(bodyOf(torus(0.2, 0.06, 20, 10), uneven), padding, true, 600, 4);
  }
}

TEST(BodyGrid, AnOpenMeshHasNoInside) {
  TriangleMesh open = boxMesh({0.3, 0.2, 0.2});
  open.triangles.pop_back();
  for (const double padding : {0.0, 0.01})
    compare(bodyOf(open), padding, false, 1000, 5);
  const BodyGrid grid(BodySurface(bodyOf(open).body), {0.01, 0});
  EXPECT_FALSE(grid.isBody({0, 0, 0}));
  EXPECT_TRUE(
      BodyGrid(BodySurface(bodyOf(boxMesh({0.3, 0.2, 0.2})).body), {0.01, 0}).isBody({0, 0, 0}));
}

TEST(BodyGrid, ClosedPartsOfOneMeshCountOneByOne) {
  // Two boxes that overlap: by the parity of both together, the middle would be outside. An open
  // part beside them changes nothing.
  TriangleMesh mesh = boxMesh({0.2, 0.2, 0.2});
  const TriangleMesh other = boxMesh({0.4, 0.1, 0.1});
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{0.5f, 0, 0}, {0.5f, 0.1f, 0}, {0.5f, 0, 0.1f}});
  mesh.triangles.push_back({last, last + 1, last + 2});
  const BodyGrid grid(BodySurface(bodyOf(mesh).body), {0.005, 0});
  EXPECT_TRUE(grid.isBody({0, 0, 0}));
  EXPECT_TRUE(grid.isBody({0.15, 0, 0}));
  EXPECT_TRUE(grid.isBody({0.03, 0.08, 0}));
  EXPECT_FALSE(grid.isBody({0.15, 0.08, 0}));
}

/// Each triangle again, with vertices of its own and turned round, as some exporters do.
TriangleMesh doubled(TriangleMesh mesh, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::array<std::uint32_t, 3> corners = mesh.triangles[i];
    for (const std::uint32_t corner : corners)
      mesh.vertices.push_back(Eigen::Vector3f(mesh.vertices[corner]));
    mesh.triangles.push_back({first + 2, first + 1, first});
  }
  return mesh;
}

TEST(BodyGrid, AClosedMeshWhoseFacesAreDoubledHasAnInside) {
  const TriangleMesh mesh = torus(0.2, 0.06, 24, 12);
  for (const std::size_t count : {mesh.triangles.size(), mesh.triangles.size() / 2}) {
    const BodyGrid grid(BodySurface(bodyOf(doubled(mesh, count)).body), {0.01, 0, kMaxBytes});
    EXPECT_TRUE(grid.isBody({0.2, 0, 0})) << count;
    EXPECT_TRUE(grid.isBody({-0.01, -0.2, 0})) << count;
    EXPECT_FALSE(grid.isBody({0, 0, 0})) << count;
  }
  TriangleMesh open = mesh;
  open.triangles.pop_back();
  open = doubled(open, open.triangles.size());
  EXPECT_FALSE(BodyGrid(BodySurface(bodyOf(open).body), {0.01, 0, kMaxBytes}).isBody({0.2, 0, 0}));
}

TriangleMesh boxesWithAWall() {
  TriangleMesh mesh = boxMesh({0.2, 0.2, 0.2});
  const TriangleMesh other = mesh;
  for (const Eigen::Vector3f& vertex : other.vertices)
    mesh.vertices.push_back(vertex + Eigen::Vector3f(0.2f, 0, 0));
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({a + 8, b + 8, c + 8});
  for (std::size_t i = 0; i < 8; ++i) {  // the vertices of the wall have the same coordinates
    if (mesh.vertices[i + 8].x() < 0.15f) mesh.vertices[i + 8].x() = 0.1f;
  }
  return mesh;
}

/// Also if each triangle is there twice or four times as often.
TEST(BodyGrid, BoxesThatShareAWallAreBothFilled) {
  TriangleMesh mesh = boxesWithAWall();
  for (int doublings = 0; doublings < 3; ++doublings) {
    const BodyGrid grid(BodySurface(bodyOf(mesh).body), {0.005, 0, kMaxBytes});
    EXPECT_TRUE(grid.isBody({0.01, 0.02, 0.03})) << doublings;
    EXPECT_TRUE(grid.isBody({0.21, 0.02, 0.03})) << doublings;
    EXPECT_FALSE(grid.isBody({0.32, 0.02, 0.03})) << doublings;
    mesh = doubled(mesh, mesh.triangles.size());
  }
}

TEST(BodyGrid, WhatBoxesHaveInCommonThatShareAnEdgeIsFilled) {
  TriangleMesh mesh = boxMesh({0.2, 0.2, 0.2});
  const TriangleMesh other = mesh;
  for (Eigen::Vector3f vertex : other.vertices) {
    if (vertex.y() > 0) vertex.y() = 0.02f;
    if (vertex.z() > 0) vertex.z() = 0.3f;
    mesh.vertices.push_back(vertex);
  }
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({a + 8, b + 8, c + 8});
  const BodySurface surface(bodyOf(mesh).body);
  EXPECT_EQ(surface.contains({0.01, -0.04, 0.02}), true);  // of both
  EXPECT_EQ(surface.contains({0.01, 0.05, 0.02}), true);
  EXPECT_EQ(surface.contains({0.01, -0.04, 0.2}), true);
  EXPECT_EQ(surface.contains({0.01, 0.05, 0.2}), false);
}

TEST(BodyGrid, ATurnedTriangleDoesNotMakeOutsideInside) {
  TriangleMesh box = boxMesh({0.2, 0.2, 0.2});
  for (auto& [a, b, c] : box.triangles) {
    std::swap(b, c);
    const BodySurface surface(bodyOf(box).body);
    EXPECT_EQ(surface.contains({0.01, 0.02, 0.03}), true);
    EXPECT_EQ(surface.contains({-0.22, -0.15, -0.29}), false);  // the ray passes through the box
    EXPECT_EQ(surface.contains({0.3, 0, 0}), false);
  }
}

TEST(BodyGrid, ATriangleThatIsALineLeavesNoDoubtWhatIsInside) {
  TriangleMesh box = boxMesh({0.2, 0.2, 0.2});
  box.triangles.push_back({0, 0, 7});  // the diagonal
  EXPECT_EQ(BodySurface(bodyOf(box).body).contains({0, 0, 0}), true);
  TriangleMesh ring = torus(0.2, 0.06, 24, 12);
  ring.triangles.push_back({0, 12 * 12, 0});  // through the hole
  EXPECT_EQ(BodySurface(bodyOf(ring).body).contains({0, 0, 0}), false);
}

TEST(BodyGrid, KeepsWhatLiesInTheHoleOfATorus) {
  const BodyGrid grid(BodySurface(bodyOf(torus(0.1, 0.03, 48, 24)).body),
                      {0.01, kSlack, kMaxBytes});
  for (double radius = 0; radius < 0.0595; radius += 0.001)
    EXPECT_FALSE(grid.isBody({radius, 0, 0})) << radius;
  EXPECT_TRUE(grid.isBody({0.07, 0, 0}));
  EXPECT_TRUE(grid.isBody({0.1, 0, 0}));
}

TEST(BodyGrid, ARegionThatNoSurfaceDividesHasOneSide) {
  // A shell in a shell: the hollow between them and the one within are inside a closed part. Cells
  // are smaller than the gap, so each hollow is a region of its own.
  TriangleMesh mesh = boxMesh({0.4, 0.4, 0.4});
  const TriangleMesh inner = boxMesh({0.2, 0.2, 0.2});
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const auto& [a, b, c] : inner.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
  const BodyGrid grid(BodySurface(bodyOf(mesh).body), {0.01, kSlack, kMaxBytes});
  for (double x = 0; x < 0.2095; x += 0.003)
    EXPECT_TRUE(grid.isBody({x, 0.001, 0.002})) << x;
  EXPECT_FALSE(grid.isBody({0.2111, 0.001, 0.002}));
  TriangleMesh open = mesh;  // without a wall, the outer shell has no inside
  open.triangles.erase(open.triangles.begin());
  const BodyGrid half_open(BodySurface(bodyOf(open).body), {0.01, kSlack, kMaxBytes});
  EXPECT_TRUE(half_open.isBody({0, 0, 0}));
  EXPECT_FALSE(half_open.isBody({0.15, 0, 0}));
}

TEST(BodyGrid, SolidsAreFilled) {
  const Eigen::Affine3d pose(Eigen::Translation3d(0.5, 0, 0));
  const Body body{{{{nullptr, Solid::kEllipsoid, {0.2, 0.2, 0.2}, pose}},
                   {{nullptr, Solid::kBox, {0.1, 0.1, 0.4}}},
                   {{nullptr, Solid::kCylinder, {0.1, 0.1, 0.2}, pose.inverse()}}}};
  const BodyGrid grid(BodySurface(body), {0.01, kSlack, kMaxBytes});
  Random random(6);
  const auto distance = [](const Eigen::Vector3d& p) {
    const Eigen::Vector3d ball = p - Eigen::Vector3d(0.5, 0, 0);
    const Eigen::Vector3d box = (p.cwiseAbs() - Eigen::Vector3d(0.05, 0.05, 0.2)).cwiseMax(0);
    const double side = std::max(std::hypot(p.x() + 0.5, p.y()) - 0.05, 0.0);
    const double end = std::max(std::abs(p.z()) - 0.1, 0.0);
    return std::min({std::max(ball.norm() - 0.1, 0.0), box.norm(), std::hypot(side, end)});
  };
  int near = 0;
  for (int i = 0; i < 8000; ++i) {
    const Eigen::Vector3d point(random.uniform(-0.7, 0.7), random.uniform(-0.2, 0.2),
                                random.uniform(-0.3, 0.3));
    const double found = distance(point);
    if (std::abs(found - 0.01) < 1e-6) continue;
    EXPECT_EQ(grid.isBody(point), found < 0.01) << point.transpose();
    near += found < 0.01;
  }
  EXPECT_GT(near, 200);
}

TEST(BodyGrid, PointsThatAreNotFiniteAreNoBody) {
  const BodyGrid grid(BodySurface(bodyOf(boxMesh({1, 1, 1})).body), {0.01, 0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 1e300}) {
    EXPECT_FALSE(grid.isBody({bad, 0, 0}));
    EXPECT_FALSE(grid.isBody({0, bad, 0}));
    EXPECT_FALSE(grid.isBody({0, 0, bad}));
  }
  EXPECT_FALSE(BodyGrid(BodySurface(Body()), {0.01, 0}).isBody({0, 0, 0}));
}

TEST(BodyGrid, TellsThatAShapeIsTooLarge) {
  EXPECT_TRUE(BodyGrid(BodySurface(Body()), {0.01, 0}).isWhole());
  MeshBody body = bodyOf(boxMesh({1, 1, 1}));
  EXPECT_TRUE(BodyGrid(BodySurface(body.body), {0.01, 0, 1000}).isWhole());
  body.add(boxMesh({1e12, 1, 1}), Eigen::Affine3d(Eigen::Scaling(1e300)));
  EXPECT_FALSE(BodyGrid(BodySurface(body.body), {0.01, 0, 1000}).isWhole());
}

TEST(BodyGrid, MemoryIsBounded) {
  for (const std::size_t max_bytes : {16u, 1000u, 65536u}) {
    const BodyGrid grid(BodySurface(bodyOf(torus(0.3, 0.1, 12, 8)).body), {0.001, 0, max_bytes});
    EXPECT_LE(grid.bytes(), max_bytes);
    EXPECT_TRUE(grid.isBody({0.3, 0, 0}));
    EXPECT_FALSE(grid.isBody({0, 0, 0}));
  }
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts contain every triangle, agree with the box of the link, and are tight.
#include "link_bounds/geometry/parts/link_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "link_bounds/geometry/shape/link_boxes.h"
#include "testing/part_meshes.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

constexpr std::size_t kLevels[] = {1, 2, 4, 8, 16, 64, 256};

/// Turned by 30 and 45 degrees about the axes, then random.
std::vector<Eigen::Affine3d> poses() {
  std::vector<Eigen::Affine3d> result{Eigen::Affine3d::Identity()};
  for (const double degrees : {30, 45}) {
    for (int k = 0; k < 3; ++k) {
      result.push_back(Eigen::Translation3d(1, -2, 3) *
                       Eigen::Affine3d(brute_force::turned(degrees, Eigen::Vector3d::Unit(k))));
    }
  }
  brute_force::Random random(1);
  for (int i = 0; i < 5; ++i)
    result.push_back(random.rigid(10));
  return result;
}

/// A mesh scaled by a thousandth, one that is mirrored and stretched, a cylinder and a ball.
std::vector<DivisibleShape> mixedLink() {
  brute_force::Random random(2);
  Eigen::Affine3d small = random.rigid(0.5);
  small.linear() *= 1e-3;
  Eigen::Affine3d mirrored = random.rigid(0.5);
  mirrored.linear() *= Eigen::Vector3d(-0.5, 1, 2).asDiagonal();
  TriangleMesh large = soup(100, 3);
  for (Eigen::Vector3f& vertex : large.vertices)
    vertex *= 1e3f;
  return {divisible(large, small), solid(Solid::kCylinder, {0.4, 0.4, 2}, {2, 0, 0}),
          divisible(hook(24, 8), mirrored), solid(Solid::kEllipsoid, {1, 1, 1}, {-2, 1, 0})};
}

/// How far a face of any shape may be outside the exact one [m].
double allowed(const std::vector<DivisibleShape>& shapes, const Eigen::Affine3d& pose, int axis) {
  double largest = 0;
  for (const DivisibleShape& divisible : shapes) {
    const double magnitude = (divisible.mesh ? largestCoordinate(divisible.mesh->vertices) : 0) +
                             divisible.shape.size.maxCoeff() / 2;
    const Eigen::Affine3d world_from_shape = pose * divisible.shape.link_from_shape;
    largest = std::max(largest, allowedExcess(world_from_shape, axis, magnitude));
  }
  return largest;
}

std::vector<Eigen::Vector3f> corners(const TriangleMesh& mesh, std::size_t triangle) {
  std::vector<Eigen::Vector3f> result;
  for (const std::uint32_t vertex : mesh.triangles[triangle])
    result.push_back(mesh.vertices[vertex]);
  return result;
}

std::vector<Aabb> boxesOf(const std::vector<LinkPart>& parts, const Eigen::Affine3d& pose) {
  std::vector<Aabb> boxes;
  for (const LinkPart& part : parts)
    boxes.push_back(boxOf(part, pose));
  return boxes;
}

std::size_t uncovered(const DivisibleShape& shape, const std::vector<Aabb>& boxes,
                      const Eigen::Affine3d& pose) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < shape.mesh->triangles.size(); ++i) {
    const QuadBox exact = exactBox(corners(*shape.mesh, i), pose * shape.shape.link_from_shape);
    count += std::none_of(boxes.begin(), boxes.end(),
                          [&exact](const Aabb& box) { return contains(box, exact); });
  }
  return count;
}

TEST(LinkParts, EveryTriangleIsInsideOnePartInAnyPose) {
  const auto shapes = mixedLink();
  for (const std::size_t max_parts : {2u, 7u, 64u}) {
    const auto parts = splitIntoParts(shapes, max_parts);
    for (const Eigen::Affine3d& pose : poses()) {
      const auto boxes = boxesOf(parts, pose);
      for (const DivisibleShape& shape : shapes) {
        if (!shape.mesh) continue;
        ASSERT_EQ(uncovered(shape, boxes, pose), 0u) << max_parts << "\n" << pose.matrix();
      }
    }
  }
}

TEST(LinkParts, TheUnionContainsTheBruteForceBox) {
  const auto shapes = mixedLink();
  for (const std::size_t max_parts : {3u, 64u}) {
    const auto parts = splitIntoParts(shapes, max_parts);
    for (const Eigen::Affine3d& pose : poses()) {
      Aabb all;
      for (const Aabb& box : boxesOf(parts, pose))
        all.extend(box);
      for (const DivisibleShape& shape : shapes) {
        if (!shape.mesh) continue;
        const QuadBox exact = exactBox(shape.mesh->vertices, pose * shape.shape.link_from_shape);
        ASSERT_TRUE(contains(all, exact));
      }
    }
  }
}

TEST(LinkParts, EachFaceOfTheUnionAgreesWithThatOfTheLink) {
  const auto shapes = mixedLink();
  const auto whole = splitIntoParts(shapes, 1);
  ASSERT_EQ(whole.size(), 1u);
  for (const std::size_t max_parts : kLevels) {
    const auto parts = splitIntoParts(shapes, max_parts);
    for (const Eigen::Affine3d& pose : poses()) {
      const Aabb link = boxOf(whole.front(), pose);
      Aabb all;
      for (const Aabb& box : boxesOf(parts, pose))
        all.extend(box);
      for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(all.min()[k], link.min()[k], allowed(shapes, pose, k)) << max_parts;
        ASSERT_NEAR(all.max()[k], link.max()[k], allowed(shapes, pose, k)) << max_parts;
      }
    }
  }
}

TEST(LinkParts, EachPartIsTightAroundItsTriangles) {
  // The triangles of a soup share no vertex, so each point belongs to one triangle.
  const auto shape = divisible(soup(300, 4));
  const auto parts = splitIntoParts({shape}, 32);
  EXPECT_GT(parts.size(), 16u);
  for (const Eigen::Affine3d& pose : poses()) {
    std::vector<Aabb> exact(parts.size());
    for (std::size_t i = 0; i < shape.mesh->triangles.size(); ++i) {
      const Aabb triangle = brute_force::box(corners(*shape.mesh, i), pose);
      std::size_t home = parts.size();
      for (std::size_t p = 0; p < parts.size() && home == parts.size(); ++p) {
        if (boxOf(parts[p], pose).contains(triangle)) home = p;
      }
      ASSERT_LT(home, parts.size());
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const Aabb box = boxOf(parts[p], pose);
      const QuadBox bound = exactBox(parts[p].front().points->points(), pose);
      ASSERT_TRUE(contains(box, bound));
      for (int k = 0; k < 3; ++k)
        ASSERT_LE(excess(box, bound, k), allowed({shape}, pose, k));
    }
  }
}

void expectFalling(const std::vector<DivisibleShape>& shapes, double at_64, const char* name) {
  const Eigen::Affine3d rest = Eigen::Affine3d::Identity();
  const double whole = volumeOf(splitIntoParts(shapes, 1), rest);
  double last = whole;
  for (const std::size_t max_parts : kLevels) {
    const double sum = volumeOf(splitIntoParts(shapes, max_parts), rest);
    EXPECT_LE(sum, last * (1 + 1e-12)) << name << ", " << max_parts;
    if (max_parts == 64) {
      EXPECT_LE(sum, at_64 * whole) << name;
    }
    last = sum;
  }
}

TEST(LinkParts, TheSumOfVolumesFallsLevelByLevel) {
  expectFalling(mixedLink(), 0.1, "mixed");
  expectFalling({divisible(hook(60, 12))}, 0.15, "hook");
  expectFalling({divisible(ball(40, 80))}, 0.5, "ball");
  expectFalling({divisible(soup(500, 5))}, 0.8, "soup");
}

TEST(LinkParts, OnTheAverageOfPosesItFallsTooOrRisesLittle) {
  constexpr double kRise = 1.2;  // the boxes of eighths of a ball grow when the ball is turned
  for (const TriangleMesh& mesh : {hook(60, 12), ball(40, 80), soup(500, 7)}) {
    const std::vector<DivisibleShape> shapes{divisible(mesh)};
    double last = std::numeric_limits<double>::infinity();
    double whole = 0;
    for (const std::size_t max_parts : kLevels) {
      const auto parts = splitIntoParts(shapes, max_parts);
      brute_force::Random same(8);
      double sum = 0;
      for (int i = 0; i < 50; ++i)
        sum += volumeOf(parts, same.rigid(0));
      EXPECT_LT(sum, last * kRise) << max_parts;
      last = sum;
      if (max_parts == 1) whole = sum;
    }
    EXPECT_LT(last, 0.5 * whole);
  }
}

TEST(LinkParts, AFewLargeTrianglesWeighAsMuchAsManySmallOnes) {
  // Two plates at an angle, one cut into 2 triangles and one into 20000.
  const auto plate = [](std::uint32_t squares, bool stands) {
    return divisible(surface(squares, squares, [stands](double s, double t) -> Eigen::Vector3d {
      return stands ? Eigen::Vector3d(0, s, t) : Eigen::Vector3d(s, t, 0);
    }));
  };
  const auto parts = splitIntoParts({plate(1, true), plate(100, false)}, 2);
  EXPECT_EQ(parts.size(), 2u);
  EXPECT_LE(volumeOf(parts, Eigen::Affine3d::Identity()), 1e-3);
}

}  // namespace
}  // namespace link_bounds

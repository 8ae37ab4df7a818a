// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The number of parts, their memory, and shapes that cannot be split.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <set>
#include <stdexcept>

#include "testing/numbers.h"
#include "testing/part_meshes.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

std::size_t countOf(const std::vector<LinkPart>& parts, const DivisibleShape& shape) {
  std::size_t count = 0;
  for (const LinkPart& part : parts) {
    count += static_cast<std::size_t>(
        std::count_if(part.begin(), part.end(), [&shape](const Shape& other) {
          return other.solid == shape.shape.solid && other.size == shape.shape.size &&
                 other.link_from_shape.matrix() == shape.shape.link_from_shape.matrix();
        }));
  }
  return count;
}

/// The memory of points that are not shared with the link.
std::size_t bytesOf(const std::vector<LinkPart>& parts, const DivisibleShape& link) {
  std::set<const PointSet*> seen{link.shape.points.get()};
  std::size_t bytes = 0;
  for (const LinkPart& part : parts) {
    for (const Shape& shape : part) {
      if (shape.points && seen.insert(shape.points.get()).second) bytes += shape.points->bytes();
    }
  }
  return bytes;
}

void expectUndivided(const std::vector<DivisibleShape>& shapes) {
  const auto parts = splitIntoParts(shapes, 8);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts.front().size(), shapes.size());
}

TEST(PartLimits, ThereAreAtMostMaxParts) {
  const std::vector<DivisibleShape> hooks{divisible(hook(60, 12)), divisible(soup(200, 1))};
  for (std::size_t max_parts = 2; max_parts <= 256; max_parts = max_parts * 3 / 2 + 1) {
    const auto parts = splitIntoParts(hooks, max_parts);
    EXPECT_LE(parts.size(), max_parts);
    for (const LinkPart& part : parts)
      EXPECT_FALSE(part.empty());
  }
  EXPECT_GT(splitIntoParts(hooks, 256).size(), 128u);
}

TEST(PartLimits, OnePartIsTheLinkItself) {
  const std::vector<DivisibleShape> shapes{divisible(hook(20, 8)),
                                           solid(Solid::kBox, {1, 1, 1}, {3, 0, 0})};
  const auto parts = splitIntoParts(shapes, 1);
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0].size(), 2u);
  EXPECT_EQ(parts[0][0].points, shapes[0].shape.points);
}

TEST(PartLimits, ALinkWithoutShapesHasNoPart) {
  EXPECT_TRUE(splitIntoParts({}, 8).empty());
}

TEST(PartLimits, SolidsAreIndivisibleAndEachInOnePart) {
  std::vector<DivisibleShape> shapes;
  for (int i = 0; i < 5; ++i)
    shapes.push_back(solid(Solid::kCylinder, {0.2, 0.2, 1.0 + i}, {1.0 * i * i, 0.5 * i, 0}));
  for (const std::size_t max_parts : {2u, 3u, 5u, 256u}) {
    const auto parts = splitIntoParts(shapes, max_parts);
    EXPECT_EQ(parts.size(), std::min<std::size_t>(max_parts, 5));
    for (const DivisibleShape& shape : shapes)
      EXPECT_EQ(countOf(parts, shape), 1u);
  }
}

TEST(PartLimits, OnlyAsManyPartsAsHelp) {
  // Two halves of a box are no tighter than the box.
  expectUndivided(
      {solid(Solid::kBox, {1, 1, 1}, {0, 0, 0}), solid(Solid::kBox, {1, 1, 1}, {0, 0, 0})});
}

TEST(PartLimits, TheMemoryOfTheParts) {
  const TriangleMesh meshes[] = {kIsSanitized ? hook(30, 12) : hook(200, 40),
                                 kIsSanitized ? ball(20, 40) : ball(60, 120),
                                 soup(repetitions(5000), 2)};
  for (const TriangleMesh& mesh : meshes) {
    const DivisibleShape shape = divisible(mesh);
    for (const std::size_t max_parts : {2u, 3u, 8u, 64u, 256u}) {
      const auto parts = splitIntoParts({shape}, max_parts);
      EXPECT_LE(bytesOf(parts, shape), kBytesPerPart * parts.size()) << max_parts;
    }
  }
}

TEST(PartLimits, AMeshWhosePartsDoNotFitInMemoryIsNotSplit) {
  // Two balls. Every vertex can be extreme: 3 * 16 kB are too little for 10000 of them.
  TriangleMesh mesh = ball(50, 100);
  const TriangleMesh one = mesh;
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3f& vertex : one.vertices)
    mesh.vertices.push_back(vertex + Eigen::Vector3f(5, 5, 5));
  for (const auto& [i, j, k] : one.triangles)
    mesh.triangles.push_back({i + offset, j + offset, k + offset});
  const DivisibleShape dense = divisible(mesh);
  const DivisibleShape box = solid(Solid::kBox, {1, 1, 1}, {9, 9, 9});
  const auto few = splitIntoParts({dense, box}, 3);
  ASSERT_EQ(few.size(), 2u);
  EXPECT_EQ(bytesOf(few, dense), 0u);
  const auto many = splitIntoParts({dense, box}, 64);
  EXPECT_GT(many.size(), 32u);
}

TEST(PartLimits, AMeshThatIsCompleteInOnePartSharesThePointsOfTheLink) {
  const DivisibleShape left = divisible(ball(10, 20));
  const DivisibleShape right =
      divisible(ball(10, 20), Eigen::Affine3d(Eigen::Translation3d(5, 1, 0)));
  const auto parts = splitIntoParts({left, right}, 2);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(countOf(parts, left), 1u);
  EXPECT_TRUE(parts[0][0].points == left.shape.points || parts[1][0].points == left.shape.points);
}

TEST(PartLimits, OneTriangle) {
  expectUndivided({divisible({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}})});
}

TEST(PartLimits, EqualTriangles) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, {}};
  mesh.triangles.assign(1000, {0, 1, 2});
  expectUndivided({divisible(mesh)});
}

TEST(PartLimits, APoint) {
  expectUndivided({divisible({{{1, 2, 3}}, {{0, 0, 0}}})});
}

TEST(PartLimits, FlatMeshesAreSplitForTheSakeOfOtherPoses) {
  const auto flat = surface(30, 30, [](double s, double t) -> Eigen::Vector3d {
    return {s, t, 0};
  });
  const auto parts = splitIntoParts({divisible(flat)}, 16);
  EXPECT_GT(parts.size(), 8u);
  const Eigen::Affine3d pose(brute_force::turned(30, {1, 1, 0}));
  EXPECT_LT(volumeOf(parts, pose), 0.5 * volumeOf(splitIntoParts({divisible(flat)}, 1), pose));
}

TEST(PartLimits, ScalesThatFlattenOrVanish) {
  for (const double scale : {0.0, 1e-300, 1e-30, 1e-3, 1e25}) {
    for (const Eigen::Vector3d& scales :
         {Eigen::Vector3d(1, 1, scale), Eigen::Vector3d(scale, scale, scale)}) {
      const Eigen::Affine3d link_from_shape(Eigen::Scaling(scales));
      const auto parts = splitIntoParts({divisible(hook(20, 8), link_from_shape)}, 8);
      ASSERT_FALSE(parts.empty());
      Aabb all;
      for (const LinkPart& part : parts)
        all.extend(boxOf(part, kIdentity));
      EXPECT_TRUE(all.contains(brute_force::box(hook(20, 8).vertices, link_from_shape))) << scale;
    }
  }
}

TEST(PartLimits, AScaleThatGivesNoBoxLeavesTheLinkUndivided) {
  for (const double scale : {1e31, 1e300, std::nan(""), HUGE_VAL}) {
    const Eigen::Affine3d link_from_shape(Eigen::Scaling(scale));
    expectUndivided({divisible(hook(20, 8)), divisible(hook(20, 8), link_from_shape)});
  }
}

TEST(PartLimits, TinyAndHugeSolids) {
  expectUndivided({solid(Solid::kBox, {1e-40, 1e-40, 1e-40}, {0, 0, 0})});
  expectUndivided({solid(Solid::kBox, {1e300, 1e300, 1e300}, {0, 0, 0})});
}

TEST(PartLimits, AnInterruptEndsTheWork) {
  const DivisibleShape shape = divisible(kIsSanitized ? hook(100, 40) : hook(300, 100));
  std::size_t calls = 0;
  splitIntoParts({shape}, 64, [&calls] { ++calls; });
  EXPECT_GT(calls, 10u);
  for (const std::size_t end : {std::size_t{1}, calls / 2, calls}) {
    std::size_t left = end;
    const auto interrupt = [&left] {
      if (--left == 0) throw std::runtime_error("enough");
    };
    EXPECT_THROW(splitIntoParts({shape}, 64, interrupt), std::runtime_error);
  }
}

TEST(PartLimits, ManyTrianglesInReasonableTime) {
  TriangleMesh mesh = kIsSanitized ? hook(100, 50) : hook(1000, 500);
  brute_force::Random random(3);
  for (Eigen::Vector3f& vertex : mesh.vertices)
    vertex += random.vector(0.01).cast<float>();
  const DivisibleShape shape = divisible(mesh);
  const auto start = std::chrono::steady_clock::now();
  const auto parts = splitIntoParts({shape}, 64);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::cout << "parts: " << mesh.triangles.size() << " triangles into " << parts.size() << " in "
            << time.count() << " s\n";
  EXPECT_GT(parts.size(), 32u);
  EXPECT_LE(bytesOf(parts, shape), kBytesPerPart * parts.size());
  EXPECT_LT(time.count(), 60);
}

}  // namespace
}  // namespace link_bounds

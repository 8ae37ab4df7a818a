// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Both bounds against a comparison of all triangles in long double, and in quadruple precision
// where it is close and now and then.
#include "link_bounds/geometry/distance/body_distance.h"

#include <gtest/gtest.h>

#include "testing/distance_bodies.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

/// Every hundredth comparison is decided in quadruple precision, besides the close ones.
constexpr int kQuad = 100;

/// A sanitizer makes all of this slow.
constexpr int kShare = kIsSanitized ? 20 : 1;

/// What long double may err by, as a part of the size; the quadruple ones hold that.
constexpr distance_oracle::Long kLongError = 1e-16L;

void expectQuad(const BodyDistance& found, const MeshBody& a, const Eigen::Affine3d& world_from_a,
                const MeshBody& b, const Eigen::Affine3d& world_from_b,
                distance_oracle::Long in_long_double, distance_oracle::Long error) {
  const Quad exact = distance_oracle::quadDistance(
      a.placed(world_from_a), b.placed(world_from_b), a.placed<Quad>(world_from_a),
      b.placed<Quad>(world_from_b), in_long_double, 4 * error);
  ASSERT_TRUE(static_cast<Quad>(found.lower) <= exact);
  ASSERT_TRUE(static_cast<Quad>(found.upper) >= exact);
  ASSERT_LE(std::abs(static_cast<distance_oracle::Long>(exact - in_long_double)), error);
}

/// `size` is that of the bodies and of their distance, which rounding is proportional to.
void expectBounds(const MeshBody& a, const Eigen::Affine3d& world_from_a, const MeshBody& b,
                  const Eigen::Affine3d& world_from_b, const DistanceGoal& goal, double size) {
  const auto found = bodyDistance(a.body, world_from_a, b.body, world_from_b, goal);
  ASSERT_TRUE(found);
  const auto first = a.placed(world_from_a);
  const auto second = b.placed(world_from_b);
  const distance_oracle::Long exact = distance_oracle::distance(first, second);
  ASSERT_LE(found->lower, exact);
  ASSERT_GE(found->upper, exact);
  static int comparisons = 0;
  const distance_oracle::Long error =
      kLongError * (size + world_from_a.translation().norm() + world_from_b.translation().norm());
  const bool is_close =
      (found->lower > 0 && exact - found->lower < error) || found->upper - exact < error;
  if (++comparisons % kQuad == 0 || is_close)
    expectQuad(*found, a, world_from_a, b, world_from_b, exact, error);
  ASSERT_GE(found->lower, 0);
  const double world = world_from_a.translation().norm() + world_from_b.translation().norm();
  const double rounding = 1e-12 * size + 1e-15 * world;
  ASSERT_NEAR((found->on_second - found->on_first).norm(), found->upper, rounding);
  ASSERT_LE(distance_oracle::distance(found->on_first, first), 1e-9 * size + rounding);
  ASSERT_LE(distance_oracle::distance(found->on_second, second), 1e-9 * size + rounding);
  if (found->lower < goal.limit) {
    ASSERT_LE(found->upper - found->lower, goal.accuracy + rounding)
        << static_cast<int>(found->level);
  }
  if (found->lower > 0) {
    ASSERT_NEAR(found->normal.norm(), 1, 1e-12);
  } else {
    ASSERT_EQ(found->normal, Eigen::Vector3d::Zero());
  }
}

MeshBody anyBody(Random& random, double size) {
  MeshBody result;
  result.add(anyMesh(random, size));
  return result;
}

TEST(BodyDistance, OfManySmallMeshes) {
  Random random(13);
  for (int i = 0; i < 40000 / kShare; ++i) {
    MeshBody a, b;
    a.add(anyMesh(random, 0.3, 4));
    b.add(anyMesh(random, 0.3, 4));
    for (int j = 0; j < 5; ++j)
      expectBounds(a, random.rigid(0.5), b, random.rigid(0.5), {}, 1);
  }
}

/// Eight small triangles each, which are one leaf of a tree: their pairs have very different
/// normals.
TEST(BodyDistance, OfTwoLeaves) {
  Random random(14);
  const auto leaf = [&random] {
    std::vector<Eigen::Vector3f> vertices = random.points(24, 0.3);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] = vertices[i - i % 3] + 0.1f * random.vector(1).cast<float>();
    MeshBody result;
    result.add(meshOf(vertices));
    return result;
  };
  for (int i = 0; i < 4000 / kShare; ++i)
    expectBounds(leaf(), random.rigid(0.4), leaf(), random.rigid(0.4), {}, 1);
}

TEST(BodyDistance, OfRandomMeshes) {
  Random random(1);
  for (int i = 0; i < 500 / kShare; ++i) {
    const MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    for (int j = 0; j < 10; ++j)
      expectBounds(a, random.rigid(0.5), b, random.rigid(0.5), {}, 1);
  }
}

TEST(BodyDistance, OfMeshesThatNearlyTouch) {
  Random random(2);
  for (int i = 0; i < repetitions(600); ++i) {
    const MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    const Eigen::Affine3d pose = random.rigid(0.5);
    Eigen::Affine3d other = random.rigid(0.5);
    // From the nearest point to a given gap.
    const BodyDistance apart = *bodyDistance(a.body, pose, b.body, other, {1e-9});
    const double gap = i % 3 == 0 ? 0 : random.magnitude(-12, -2);
    other.translation() += apart.on_first - apart.on_second + gap * apart.normal;
    expectBounds(a, pose, b, other, {}, 1);
    expectBounds(a, pose, b, other, {1e-7}, 1);
  }
}

TEST(BodyDistance, OfOneBodyAndItself) {
  Random random(3);
  for (int i = 0; i < repetitions(500); ++i) {
    const MeshBody body = anyBody(random, 0.3);
    const Eigen::Affine3d pose = random.rigid(0.5);
    expectBounds(body, pose, body, pose, {}, 1);
    Eigen::Affine3d moved = pose;
    moved.translation() += random.vector(random.magnitude(-9, 0));
    expectBounds(body, pose, body, moved, {}, 1);
  }
}

TEST(BodyDistance, OfMirroredStretchedAndSeveralMeshes) {
  Random random(4);
  for (int i = 0; i < repetitions(200); ++i) {
    MeshBody a, b;
    for (int j = 0; j < 1 + i % 3; ++j) {
      Eigen::Affine3d small = random.affine(0.5);
      small.linear() *= 1e-3;
      a.add(anyMesh(random, 300), small);
      b.add(anyMesh(random, 0.3), random.affine(0.5));
    }
    for (int j = 0; j < 4; ++j)
      expectBounds(a, random.rigid(2), b, random.rigid(2), {}, 10);
  }
}

TEST(BodyDistance, FarFromTheOriginOfTheWorld) {
  Random random(5);
  for (int i = 0; i < repetitions(500); ++i) {
    const MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    const Eigen::Vector3d far_away = random.magnitude(3, 5) * random.vector(1);
    Eigen::Affine3d pose = random.rigid(0.5), other = random.rigid(0.5);
    pose.translation() += far_away;
    other.translation() += far_away;
    expectBounds(a, pose, b, other, {}, 1);
  }
}

TEST(BodyDistance, OfMeshesFarFromTheirOwnOrigin) {
  Random random(6);
  for (int i = 0; i < repetitions(500); ++i) {
    const Eigen::Vector3d far_away = 1e3 * random.vector(1);
    MeshBody a, b;
    a.add(meshOf(random.points(60, 0.3, far_away)));
    b.add(meshOf(random.points(60, 0.3)));
    Eigen::Affine3d pose = random.rigid(0), other = random.rigid(0.5);
    pose.translation() = -(pose.linear() * far_away);
    expectBounds(a, pose, b, other, {}, 1e3);
  }
}

TEST(BodyDistance, OfTinyAndHugeMeshes) {
  Random random(7);
  for (int i = 0; i < repetitions(2000); ++i) {
    const double size = random.magnitude(-12, 12);
    const MeshBody a = anyBody(random, size), b = anyBody(random, size);
    expectBounds(a, random.rigid(2 * size), b, random.rigid(2 * size), {1e-4 * size}, size);
  }
}

TEST(BodyDistance, OfNestedMeshesIsThatOfTheirSurfaces) {
  Random random(8);
  MeshBody shell, core;
  shell.add(boxMesh({2, 2, 2}));
  core.add(boxMesh({1, 1, 1}));
  for (int i = 0; i < repetitions(1000); ++i)
    expectBounds(shell, random.rigid(0.1), core, random.rigid(0.1), {}, 1);
  const Eigen::Affine3d still = Eigen::Affine3d::Identity();
  EXPECT_NEAR(bodyDistance(shell.body, still, core.body, still)->upper, 0.5, 1e-9);
}

TEST(BodyDistance, OfParallelPlates) {
  // All of one plate is equally near to the other.
  Random random(9);
  TriangleMesh plate;
  for (std::uint32_t i = 0; i < 100; ++i) {
    plate.vertices.emplace_back(0.1f * static_cast<float>(i % 10),
                                0.1f * static_cast<float>(i / 10), 0.0f);
    if (i % 10 == 9 || i >= 90) continue;
    plate.triangles.push_back({i, i + 1, i + 10});
    plate.triangles.push_back({i + 1, i + 11, i + 10});
  }
  MeshBody body;
  body.add(plate);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Affine3d pose = random.rigid(1);
    const Eigen::Affine3d other = pose * Eigen::Translation3d(0.1, 0.2, random.uniform(0.01, 1));
    expectBounds(body, pose, body, other, {}, 1);
  }
}

/// Of a triangle of a metre by 0.01 to 1 mm, whose plane rounding leaves few digits of.
TEST(BodyDistance, OfNeedlesIsAsAccurateAsOfOthers) {
  brute_force::Random random(11);
  for (int i = 0; i < repetitions(20000); ++i) {
    const double width = random.magnitude(-5, -3);
    const Eigen::Matrix3d axes = random.rigid(0).linear();
    const Eigen::Vector3d along = axes.col(0), across = axes.col(1), off = axes.col(2);
    const Eigen::Vector3d begin = random.vector(1);
    const Eigen::Vector3d beside = begin + along * random.uniform(0.1, 0.9) + across * 0.3 * width +
                                   off * random.magnitude(-4, -2);
    const auto toFloat = [](const Eigen::Vector3d& point) { return point.cast<float>().eval(); };
    MeshBody needle, other;
    needle.add(meshOf({toFloat(begin), toFloat(begin + along),
                       toFloat(begin + along * random.uniform(0.1, 0.9) + across * width)}));
    other.add(meshOf({toFloat(beside), toFloat(beside + random.vector(0.01) + 0.02 * off),
                      toFloat(beside + random.vector(0.01) + 0.02 * off), toFloat(begin - off),
                      toFloat(begin - off + random.vector(0.1)),
                      toFloat(begin - off + random.vector(0.1))}));
    const auto found = bodyDistance(needle.body, Eigen::Affine3d::Identity(), other.body,
                                    Eigen::Affine3d::Identity());
    ASSERT_TRUE(found);
    ASSERT_LE(found->upper - found->lower, DistanceGoal().accuracy + 1e-8) << i;
  }
}

TEST(BodyDistance, EndsAtTheLimit) {
  Random random(10);
  for (int i = 0; i < repetitions(2000); ++i) {
    const MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    const double limit = random.magnitude(-3, 0);
    expectBounds(a, random.rigid(0.5), b, random.rigid(0.5), {1e-4, limit}, 1);
  }
}

TEST(BodyDistance, AtALimitOfZeroTellsWhatMayTouch) {
  Random random(14);
  for (int i = 0; i < repetitions(2000); ++i) {
    const MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    const Eigen::Affine3d pose = random.rigid(0.3), other = random.rigid(0.3);
    const auto exact = distance_oracle::distance(a.placed(pose), b.placed(other));
    const BodyDistance found = *bodyDistance(a.body, pose, b.body, other, {1e-4, 0});
    ASSERT_LE(found.lower, exact);
    if (exact > 1e-4 + 1e-12) {
      ASSERT_GT(found.lower, 0);
    }
  }
}

TEST(BodyDistance, HoldsWhereStepsRunOut) {
  Random random(11);
  for (int i = 0; i < repetitions(500); ++i) {
    const MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    const Eigen::Affine3d pose = random.rigid(0.3), other = random.rigid(0.3);
    const auto steps = static_cast<std::size_t>(random.magnitude(0, 2)) - 1;
    const auto found = bodyDistance(a.body, pose, b.body, other,
                                    {1e-6, std::numeric_limits<double>::infinity(), steps});
    const auto exact = distance_oracle::distance(a.placed(pose), b.placed(other));
    ASSERT_LE(found->lower, exact);
    ASSERT_GE(found->upper, exact);
  }
}

TEST(BodyDistance, WithoutTrianglesIsThatOfTheHulls) {
  Random random(12);
  for (int i = 0; i < repetitions(1500); ++i) {
    MeshBody a = anyBody(random, 0.3), b = anyBody(random, 0.3);
    const Eigen::Affine3d pose = random.rigid(0.5), other = random.rigid(0.5);
    const auto first = a.placed(pose), second = b.placed(other);
    const auto exact = distance_oracle::distance(first, second);
    a.body.shapes[0].triangles = nullptr;
    if (i % 2) b.body.shapes[0].triangles = nullptr;
    const BodyDistance found = *bodyDistance(a.body, pose, b.body, other);
    ASSERT_LE(found.lower, exact);
    ASSERT_GE(found.upper, exact);
    const bool is_point = a.body.shapes[0].shape.points->size() == 1;
    ASSERT_TRUE(is_point || found.level != DistanceLevel::kMesh);
    ASSERT_LE(distance_oracle::distance(found.on_first, first), 1e-9);
    ASSERT_LE(distance_oracle::distance(found.on_second, second), 1e-9);
  }
}

}  // namespace
}  // namespace link_bounds

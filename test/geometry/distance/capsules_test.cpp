// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Capsules and balls that move, against the distances of their cores in long double.
#include "geometry/distance/capsules.h"

#include <gtest/gtest.h>

#include "link_bounds/geometry/distance/body_distances.h"
#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using distance_oracle::Long;
using distance_oracle::Vector;

/// A segment, a point or a triangle, and how far the body reaches beyond it.
struct Core {
  std::array<Eigen::Vector3d, 3> corners;
  double radius;
};

struct RoundBody {
  Body body;
  std::vector<Core> cores;
};

BodyShape solidAt(Solid solid, const Eigen::Vector3d& size, const Eigen::Affine3d& pose) {
  BodyShape result;
  result.shape.solid = solid;
  result.shape.size = size;
  result.shape.link_from_shape = pose;
  return result;
}

BodyShape ballAt(double radius, const Eigen::Vector3d& center, const Eigen::Matrix3d& axes) {
  Eigen::Affine3d pose(axes);
  pose.translation() = center;
  return solidAt(Solid::kEllipsoid, Eigen::Vector3d::Constant(2 * radius), pose);
}

/// The cylinder and the balls in any order, as a URDF has them.
void addCapsule(RoundBody& result, Random& random, double size) {
  const Eigen::Affine3d pose = random.rigid(size);
  const double radius = size * random.magnitude(-2, 0), length = size * random.magnitude(-2, 0);
  const Eigen::Vector3d a = pose * Eigen::Vector3d(0, 0, -length / 2);
  const Eigen::Vector3d b = pose * Eigen::Vector3d(0, 0, length / 2);
  std::array<BodyShape, 3> shapes{solidAt(Solid::kCylinder, {2 * radius, 2 * radius, length}, pose),
                                  ballAt(radius, a, random.rigid(1).linear()),
                                  ballAt(radius, b, random.rigid(1).linear())};
  const auto first = static_cast<std::size_t>(random.uniform(0, 3));
  for (std::size_t i = 0; i < 3; ++i)
    result.body.shapes.push_back(shapes[(first + i) % 3]);
  result.cores.push_back({{a, b, b}, radius});
}

void addBall(RoundBody& result, Random& random, double size) {
  const double radius = size * random.magnitude(-2, 0);
  const Eigen::Vector3d center = random.vector(size);
  result.body.shapes.push_back(ballAt(radius, center, random.rigid(1).linear()));
  result.cores.push_back({{center, center, center}, radius});
}

void addMesh(RoundBody& result, Random& random, double size) {
  const TriangleMesh mesh = anyMesh(random, size, 20);
  result.body.shapes.push_back(*meshShape(mesh));
  for (const auto& [i, j, k] : mesh.triangles) {
    result.cores.push_back({{mesh.vertices[i].cast<double>(), mesh.vertices[j].cast<double>(),
                             mesh.vertices[k].cast<double>()},
                            0});
  }
}

RoundBody anyRoundBody(Random& random) {
  RoundBody result;
  const double size = random.magnitude(-1, 0);
  const int count = random.uniform(0, 1) < 0.6 ? 1 : static_cast<int>(random.uniform(1, 4));
  for (int i = 0; i < count; ++i) {
    const double kind = random.uniform(0, 1);
    if (kind < 0.5) {
      addCapsule(result, random, size);
    } else if (kind < 0.7) {
      addBall(result, random, size);
    } else {
      addMesh(result, random, size);
    }
  }
  return result;
}

distance_oracle::Triangle placedCore(const Core& core, const Eigen::Affine3d& pose) {
  distance_oracle::Triangle result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = pose.cast<Long>() * Vector(core.corners[i].cast<Long>());
  return result;
}

Long exactDistance(const RoundBody& a, const Eigen::Affine3d& pose, const RoundBody& b,
                   const Eigen::Affine3d& other) {
  Long result = std::numeric_limits<double>::infinity();
  for (const Core& first : a.cores) {
    for (const Core& second : b.cores) {
      const Long between =
          distance_oracle::distance<Long>(placedCore(first, pose), placedCore(second, other));
      result = std::min(result, between - Long(first.radius) - Long(second.radius));
    }
  }
  return std::max(Long(0), result);
}

/// How far a point is outside the body.
Long outside(const RoundBody& body, const Eigen::Affine3d& pose, const Eigen::Vector3d& point) {
  Long result = std::numeric_limits<double>::infinity();
  for (const Core& core : body.cores) {
    const Long from_core =
        distance_oracle::distance<Long>(Vector(point.cast<Long>()), placedCore(core, pose));
    result = std::min(result, from_core - Long(core.radius));
  }
  return result;
}

void expectTrue(const BodyDistance& found, Long exact, double accuracy, double rounding) {
  ASSERT_LE(found.lower, exact + Long(rounding));
  ASSERT_GE(found.upper, exact - Long(rounding));
  ASSERT_LE(found.upper - found.lower, accuracy + 2e3 * rounding);
}

TEST(Capsules, HaveTheDistancesOfTheirCores) {
  Random random(1);
  const double accuracy = 1e-4;
  int apart = 0, touching = 0;
  for (int i = 0; i < repetitions(2000); ++i) {
    const RoundBody a = anyRoundBody(random), b = anyRoundBody(random);
    BodyDistances distances({accuracy});
    distances.set(0, std::make_shared<Body>(a.body));
    distances.set(1, std::make_shared<Body>(b.body));
    const double far_away = i % 3 == 0 ? 1e4 : 1;
    const Eigen::Affine3d home = random.rigid(far_away);
    Eigen::Affine3d pose = random.rigid(1.5), other = random.rigid(1.5);
    const BodyDistance begin = *bodyDistance(a.body, pose, b.body, other, {accuracy});
    // Most pairs begin close to contact, on either side.
    const double gap = (i % 2 ? 1 : -1) * random.magnitude(-9, -2);
    if (i % 5 > 0) other.pretranslate(begin.normal * (gap - begin.upper));
    for (int step = 0; step < 12; ++step) {
      const double move = step == 0 ? 0 : step % 7 == 0 ? 0.3 : 0.003;
      pose = pose * Eigen::Translation3d(random.vector(move)) *
             Eigen::AngleAxisd(move, random.vector(1).normalized());
      // At a scaled pose, a ball is none; the next pose is rigid again.
      const bool is_scaled = step % 5 == 4;
      const Eigen::Affine3d first =
          home * (is_scaled ? pose * Eigen::Scaling(1.0, 1.0, 0.7) : pose);
      const Eigen::Affine3d second = home * other;
      distances.move(0, first);
      distances.move(1, second);
      const BodyDistance found = step % 2 == 0 ? *distances.follow(0, 1) : *distances.find(0, 1);
      const double rounding = 2e-15 * (far_away + 10);
      if (is_scaled) {
        const BodyDistance plain = *bodyDistance(a.body, first, b.body, second, {accuracy});
        ASSERT_LE(found.lower, plain.upper);
        ASSERT_GE(found.upper, plain.lower);
        ASSERT_LE(found.upper - found.lower, accuracy + 1e-9) << i << " " << step;
        continue;
      }
      const Long exact = exactDistance(a, first, b, second);
      ++(exact > 0 ? apart : touching);
      ASSERT_NO_FATAL_FAILURE(expectTrue(found, exact, accuracy, rounding)) << i << " " << step;
      ASSERT_LE(outside(a, first, found.on_first), rounding) << i << " " << step;
      ASSERT_LE(outside(b, second, found.on_second), rounding) << i << " " << step;
      const BodyDistance plain = *bodyDistance(a.body, first, b.body, second, {accuracy});
      ASSERT_NO_FATAL_FAILURE(expectTrue(plain, exact, accuracy, rounding)) << i << " " << step;
    }
  }
  EXPECT_GT(apart, repetitions(600));
  EXPECT_GT(touching, repetitions(600));
}

std::size_t shapesLeft(const Body& body) {
  return withCores(std::make_shared<Body>(body))->shapes.size();
}

TEST(Capsules, AreThreeShapesThatFit) {
  Random random(2);
  for (int i = 0; i < repetitions(20000); ++i) {
    RoundBody body;
    addCapsule(body, random, 1);
    ASSERT_EQ(shapesLeft(body.body), 1u);
    addCapsule(body, random, 1);
    addBall(body, random, 1);
    ASSERT_EQ(shapesLeft(body.body), 3u);
    Body without_ball = body.body;
    without_ball.shapes.erase(without_ball.shapes.begin() + i % 3);
    ASSERT_EQ(shapesLeft(without_ball), 4u);
  }
}

TEST(Capsules, AreNoneWhereAShapeDoesNotFit) {
  const Body capsule{{solidAt(Solid::kCylinder, {0.2, 0.2, 1}, kIdentity),
                      ballAt(0.1, {0, 0, -0.5}, Eigen::Matrix3d::Identity()),
                      ballAt(0.1, {0, 0, 0.5}, Eigen::Matrix3d::Identity())}};
  ASSERT_EQ(shapesLeft(capsule), 1u);
  const auto expectNone = [&](const auto& change) {
    Body changed = capsule;
    change(changed.shapes);
    EXPECT_EQ(shapesLeft(changed), 3u);
  };
  using Shapes = std::vector<BodyShape>;
  expectNone([](Shapes& shapes) { shapes[1].shape.link_from_shape.translation().z() -= 1e-14; });
  expectNone([](Shapes& shapes) { shapes[2].shape.link_from_shape.translation().x() += 1e-14; });
  expectNone([](Shapes& shapes) { shapes[2].shape.size.setConstant(0.2 + 1e-15); });
  expectNone([](Shapes& shapes) { shapes[2].shape.size.z() = 0.3; });
  expectNone([](Shapes& shapes) { shapes[0].shape.size.y() = 0.3; });
  expectNone([](Shapes& shapes) { shapes[0].shape.link_from_shape.linear() *= 1 + 1e-14; });
  expectNone([](Shapes& shapes) { shapes[1].shape.link_from_shape.linear() *= 0.5; });
  expectNone([](Shapes& shapes) { shapes[1].tip = Eigen::Vector3d(0, 0, -2); });
  expectNone([](Shapes& shapes) { shapes[2] = shapes[1]; });
  Body many = capsule;
  many.shapes.resize(65, capsule.shapes[1]);
  EXPECT_EQ(shapesLeft(many), 65u);
}

/// Neither is searched by its centre, which would leave the bounds far apart.
TEST(Capsules, AreNoneInShapesAndPosesThatAreNotRigid) {
  Random random(3);
  for (int i = 0; i < repetitions(2000); ++i) {
    Body ball{{ballAt(1, {0, 0, 0}, random.rigid(1).linear())}};
    Eigen::Affine3d pose = random.rigid(0.5);
    const double other_scale = 1 + random.sign() * random.magnitude(-15, -0.5);
    (i % 2 ? pose : ball.shapes[0].shape.link_from_shape).linear() *= other_scale;
    const Body other{{ballAt(1, {0, 0, 0}, random.rigid(1).linear())}};
    const Eigen::Affine3d other_pose(Eigen::Translation3d(3 * random.vector(1)));
    BodyDistances distances({1e-12});
    distances.set(0, std::make_shared<Body>(ball));
    distances.set(1, std::make_shared<Body>(other));
    distances.move(0, pose);
    distances.move(1, other_pose);
    const BodyDistance found = *distances.find(0, 1);
    const BodyDistance plain = *bodyDistance(ball, pose, other, other_pose, {1e-12});
    ASSERT_LE(found.lower, plain.upper);
    ASSERT_GE(found.upper, plain.lower);
    ASSERT_LE(found.upper - found.lower, std::max(plain.upper - plain.lower, 2e-12)) << other_scale;
  }
}

TEST(Capsules, OthersStayTheSameBody) {
  EXPECT_EQ(withCores(nullptr), nullptr);
  const auto box = std::make_shared<const Body>(Body{{solidAt(Solid::kBox, {1, 1, 1}, kIdentity)}});
  EXPECT_EQ(withCores(box), box);
}

}  // namespace
}  // namespace link_bounds

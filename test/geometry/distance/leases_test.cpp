// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances that are carried along, in random sequences, against a computation without memory.
#include <gtest/gtest.h>

#include "geometry/distance/lease.h"
#include "geometry/distance/tree_front.h"
#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/distance/body_distances.h"
#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/replaced_new.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr std::size_t kBodies = 4;

/// From tiny to large: most are small, so that leases last.
Eigen::Affine3d step(Random& random) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.rotate(Eigen::AngleAxisd(random.magnitude(-9, -2), random.vector(1).normalized()));
  result.translation() = random.vector(random.magnitude(-9, -2));
  return result;
}

class Sequence {
 public:
  explicit Sequence(Random& random) : random_(random), twins_(kBodies) {
    setGoal();
    for (std::size_t i = 0; i < kBodies; ++i)
      replace(i, mixedBody(random_, 1, true));
  }

  void change() {
    if (random_.uniform(0, 30) < 1) setGoal();
    if (random_.uniform(0, 3) < 1) moveAll();
    for (std::size_t i = 0; i < kBodies; ++i) {
      if (random_.uniform(0, 3) < 1) change(i);
    }
  }

  /// Both bounds are proven, so they must fit those of another proof.
  void compare() {
    for (std::size_t i = 0; i < kBodies; ++i) {
      for (std::size_t j = 0; j < kBodies; ++j)
        compare(twins_[i], twins_[j], find(i, j));
    }
  }

 private:
  /// Now and then memory runs out first.
  std::optional<BodyDistance> find(std::size_t i, std::size_t j) {
    if (random_.uniform(0, 4) < 1) {
      replaced_new::limit = static_cast<std::size_t>(random_.magnitude(1, 5));
      try {
        ask(i, j);
      } catch (const std::bad_alloc&) {
      }
      replaced_new::limit = replaced_new::kNoLimit;
    }
    return ask(i, j);
  }

  std::optional<BodyDistance> ask(std::size_t i, std::size_t j) {
    return random_.uniform(0, 4) < 1 ? distances_.find(i, j) : distances_.follow(i, j);
  }

  void setGoal() {
    goal_ = {random_.magnitude(-5, -1), random_.sign() > 0 ? kInfinity : random_.magnitude(-2, 0)};
    distances_.setGoal(goal_);
  }

  void replace(std::size_t i, std::shared_ptr<const Body> body) {
    twins_[i] = {std::move(body), std::nullopt};
    distances_.set(i, twins_[i].body);
    if (twins_[i].body) move(i, random_.rigid(0.7));
  }

  void move(std::size_t i, const Eigen::Affine3d& pose) {
    twins_[i].pose = pose;
    distances_.move(i, pose);
  }

  /// As on a base that moves.
  void moveAll() {
    Eigen::Affine3d base = random_.rigid(random_.magnitude(-3, 3));
    if (random_.sign() > 0) base = step(random_);
    for (std::size_t i = 0; i < kBodies; ++i) {
      if (twins_[i].body && isUsablePose(*twins_[i].pose)) move(i, base * *twins_[i].pose);
    }
  }

  void change(std::size_t i) {
    const int what = static_cast<int>(random_.uniform(0, 100));
    if (what == 0 || !twins_[i].body)
      return replace(i, what == 0 ? nullptr : mixedBody(random_, 1, true));
    if (what == 1) return replace(i, mixedBody(random_, 1, true));
    const bool jumps = what < 10 || !isUsablePose(*twins_[i].pose);
    Eigen::Affine3d pose = jumps ? random_.rigid(0.7) : *twins_[i].pose * step(random_);
    if (what == 2) pose(0, 3) = random_.sign() * kInfinity;
    if (what == 3) pose(1, 1) = std::nan("");
    if (what == 4) pose(2, 3) = 1e300;
    if (what == 5) pose.linear() *= random_.uniform(0.5, 2);
    if (what == 6) pose.linear().col(0) *= -1;
    if (what == 7) pose.linear() *= 1 + random_.magnitude(-15, -5);
    move(i, pose);
  }

  void compare(const Twin& a, const Twin& b, const std::optional<BodyDistance>& found) const {
    const bool is_known = a.body && b.body;
    const auto fresh = is_known ? bodyDistance(*a.body, *a.pose, *b.body, *b.pose, goal_)
                                : std::optional<BodyDistance>();
    ASSERT_EQ(found.has_value(), fresh.has_value());
    if (!found) return;
    ASSERT_LE(found->lower, fresh->upper);
    ASSERT_LE(fresh->lower, found->upper);
    ASSERT_LE(found->lower, found->upper);
    const double points = (found->on_second - found->on_first).norm();
    const double far = a.pose->translation().norm() + b.pose->translation().norm() + 1;
    ASSERT_LE(points, found->upper + 1e-12 * far);
    ASSERT_LE(found->upper, points + 1e-6 * far);  // of poses that are hardly rigid
    if (!(found->lower > goal_.limit)) {
      ASSERT_TRUE(found->upper - found->lower <= goal_.accuracy ||
                  fresh->upper - fresh->lower > goal_.accuracy);
    }
    const double normal = found->normal.norm();
    ASSERT_NEAR(normal, found->lower > 0 ? 1 : 0, 1e-9);
  }

  Random& random_;
  std::vector<Twin> twins_;
  DistanceGoal goal_;
  BodyDistances distances_;
};

TEST(Leases, holdInRandomSequences) {
  Random random(34);
  for (int sequence = 0; sequence < repetitions(20); ++sequence) {
    Sequence bodies(random);
    for (int i = 0; i < 200 && !HasFatalFailure(); ++i) {
      bodies.change();
      bodies.compare();
    }
  }
}

/// A mesh of some hundred triangles, some swept by a box.
std::shared_ptr<const Body> longBody(Random& random, const Eigen::Affine3d& in_body) {
  const TriangleMesh mesh = bumpyBall(static_cast<std::uint32_t>(random.uniform(3, 14)), 0.03);
  const Eigen::Affine3d scaled =
      in_body * Eigen::Scaling(random.uniform(0.1, 1), random.uniform(0.1, 1), 1.0);
  BodyShape result = *meshShape(mesh, scaled);
  if (random.uniform(0, 4) < 1) {
    std::vector<Eigen::Vector3d> vertices;
    for (const Eigen::Vector3f& vertex : mesh.vertices)
      vertices.push_back(vertex.cast<double>());
    result.shape.solid = Solid::kBox;
    result.shape.size.setConstant(0.02);
    result.triangles =
        triangleTree(vertices, mesh.triangles, result.shape.solid, result.shape.size);
  }
  return std::make_shared<Body>(Body{{result}});
}

/// Two meshes that turn and drift near each other, as links do, so that most bounds of
/// nodes are carried from search to search.
TEST(Leases, HoldForNodesThatAreCarried) {
  Random random(51);
  for (int sequence = 0; sequence < repetitions(1000); ++sequence) {
    const DistanceGoal goal{1e-4, 0.1};
    BodyDistances distances(goal);
    std::array<Twin, 2> twins;
    std::array<Eigen::Affine3d, 2> steps;
    std::array<Eigen::Affine3d, 2> shown;
    const Eigen::Vector3d apart = random.vector(1).normalized() * random.uniform(0.1, 0.6);
    for (const std::size_t i : {0u, 1u}) {
      const Eigen::Affine3d in_body = random.rigid(random.sign() > 0 ? 0 : 0.2);
      twins[i] = {longBody(random, in_body), Eigen::Translation3d(i * apart) * in_body.inverse()};
      distances.set(i, twins[i].body);
      steps[i] = Eigen::AngleAxisd(random.magnitude(-4, -1), random.vector(1).normalized());
      steps[i].translation() = random.vector(random.magnitude(-5, -2.5));
    }
    for (int i = 0; i < 60; ++i) {
      for (const std::size_t k : {0u, 1u}) {
        if (random.uniform(0, 4) < 1) continue;
        twins[k].pose = *twins[k].pose * steps[k];
        shown[k] = *twins[k].pose;
        if (random.uniform(0, 50) < 1) shown[k].linear() *= 1.01;  // no lease for one moment
        distances.move(k, shown[k]);
      }
      const auto found = distances.follow(0, 1);
      if (!found) continue;  // one of them has not been moved yet
      const auto fresh = bodyDistance(*twins[0].body, shown[0], *twins[1].body, shown[1], goal);
      ASSERT_LE(found->lower, fresh->upper) << sequence << " " << i;
      ASSERT_LE(fresh->lower, found->upper);
      ASSERT_TRUE(found->lower > goal.limit || found->upper - found->lower <= goal.accuracy);
    }
  }
}

/// Adds the mesh of a box, with its center at `center`.
void addBox(TriangleMesh& mesh, const Eigen::Vector3d& size, const Eigen::Vector3f& center) {
  const TriangleMesh box = boxMesh(size);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3f& vertex : box.vertices)
    mesh.vertices.push_back(vertex + center);
  for (const auto& corners : box.triangles)
    mesh.triangles.push_back({corners[0] + first, corners[1] + first, corners[2] + first});
}

/// A gate stands astride of a post, then is lifted over it until the boxes alone prove that both
/// are beyond the limit, and comes down with a leg on the post. The bound of that leg and the post
/// is of the time before, so it must have become smaller by the way over.
TEST(Leases, HoldAfterBoxesAloneDecided) {
  const DistanceGoal goal{1e-4, 0.1};
  TriangleMesh ground, legs;
  addBox(ground, {4, 4, 1}, {0, 0, -0.5});
  for (int i = 0; i < 10; ++i) {  // piles of boxes, which trees divide
    const float z = 0.05f + 0.1f * static_cast<float>(i);
    addBox(ground, {0.3, 0.3, 0.1}, {0, 0, z});
    addBox(legs, {0.1, 0.1, 0.1}, {-1, 0, z});
    addBox(legs, {0.1, 0.1, 0.1}, {1, 0, z});
  }
  MeshBody post, gate;
  post.add(ground);
  gate.add(legs);
  Random random(61);
  for (int sequence = 0; sequence < 100; ++sequence) {
    BodyDistances distances(goal);
    distances.set(0, std::make_shared<Body>(post.body));
    distances.set(1, std::make_shared<Body>(gate.body));
    distances.move(0, Eigen::Affine3d::Identity());
    const auto lower = [&](double x, double z, double expected) {
      distances.move(1, Eigen::Affine3d(Eigen::Translation3d(x, 0, z)));
      const auto found = distances.follow(0, 1);
      EXPECT_LE(found->lower, expected + 1e-6) << sequence << " at " << x << " " << z;
      EXPECT_GE(found->upper, expected - 1e-6);
      return found->lower;
    };
    for (int i = 0; i < 4; ++i) {
      const double gap = random.uniform(0.04, 0.06);
      lower(random.uniform(-0.01, 0.01), gap, gap);
    }
    const double above = 0.1 + random.uniform(1e-4, 5e-4), on = 0.1 - random.uniform(2e-4, 5e-4);
    EXPECT_GT(lower(1, 1 + above, above), goal.limit);
    lower(1, 1 + on, on);
  }
}

/// How far the two bodies of `body` are apart on `axis`, which no triangle decides.
class Boxes {
 public:
  explicit Boxes(double limit) : distances_({1e-4, limit}) {
    auto body = std::make_shared<Body>();
    body->shapes.push_back({{nullptr, Solid::kBox, {1, 1, 1}, Eigen::Affine3d::Identity()}});
    distances_.set(0, body);
    distances_.set(1, body);
  }

  BodyDistance at(const Eigen::Affine3d& first, const Eigen::Affine3d& second) {
    distances_.move(0, first);
    distances_.move(1, second);
    return *distances_.follow(0, 1);
  }

 private:
  BodyDistances distances_;
};

Eigen::Affine3d along(double x) {
  return Eigen::Affine3d(Eigen::Translation3d(x, 0, 0));
}

TEST(Leases, carryABoundThatBecomesSmallerByTheMotion) {
  Boxes boxes(kInfinity);
  const BodyDistance before = boxes.at(along(0), along(2));
  EXPECT_NEAR(before.lower, 1, 1e-9);
  const BodyDistance away = boxes.at(along(0), along(2 + 2e-5));
  EXPECT_NEAR(away.lower, 1 - 2e-5, 1e-9);
  EXPECT_NEAR(away.upper, 1 + 2e-5, 1e-9);
  EXPECT_NEAR(away.on_second.x(), before.on_second.x() + 2e-5, 1e-12);
  const BodyDistance searched = boxes.at(along(0), along(2 + 8e-5));
  EXPECT_NEAR(searched.lower, 1 + 8e-5, 1e-9);
}

TEST(Leases, carryWhatIsBeyondTheLimitUntilItMayBeWithin) {
  Boxes boxes(0.1);
  EXPECT_NEAR(boxes.at(along(0), along(2)).lower, 1, 1e-9);
  EXPECT_NEAR(boxes.at(along(0), along(2.5)).lower, 0.5, 1e-9);
  EXPECT_NEAR(boxes.at(along(0), along(2.95)).lower, 1.95, 1e-9);
  EXPECT_NEAR(boxes.at(along(0), along(1.2)).lower, 0.2, 1e-9);
}

TEST(Leases, costNothingOnOneBase) {
  Boxes boxes(kInfinity);
  Random random(3);
  const Eigen::Affine3d second = along(2) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  const BodyDistance before = boxes.at(along(0), second);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Affine3d base = random.rigid(10);
    const BodyDistance on_base = boxes.at(base, base * second);
    ASSERT_NEAR(on_base.lower, before.lower, 1e-10);
    ASSERT_LE((base * before.on_first - on_base.on_first).norm(), 1e-12);
    ASSERT_LE((base * before.on_second - on_base.on_second).norm(), 1e-12);
    ASSERT_LE((base.linear() * before.normal - on_base.normal).norm(), 1e-12);
  }
}

TEST(Leases, areGivenToRigidPosesOnly) {
  const Ball ball{{1, 2, 3}, 4};
  Eigen::Affine3d pose(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(rigidBody(ball, pose));
  Eigen::Affine3d mirrored = pose;
  mirrored.linear().col(1) *= -1;
  EXPECT_FALSE(rigidBody(ball, mirrored));
  Eigen::Affine3d scaled = pose;
  scaled.linear() *= 1.001;
  EXPECT_FALSE(rigidBody(ball, scaled));
  pose.translation().x() = 1e10;
  EXPECT_FALSE(rigidBody(ball, pose));
  EXPECT_FALSE(rigidBody({{1e10, 0, 0}, 1}, Eigen::Affine3d::Identity()));
}

TEST(Leases, carryNoBoundThatIsTooLarge) {
  Random random(6);
  for (int i = 0; i < 100000; ++i) {
    const double lower = random.magnitude(-9, 9), moved = random.magnitude(-12, 1);
    const double more = moved + random.magnitude(-12, 1);
    const double bound = CarriedBound(lower, moved).at(more);
    const long double expected = static_cast<long double>(lower) + moved - more;
    ASSERT_LE(bound, expected);
    ASSERT_GE(bound, expected - 2e-7L * (static_cast<long double>(lower) + more));
  }
  EXPECT_LE(CarriedBound(1e300, 0).at(0), 1e300);
  EXPECT_EQ(CarriedBound().at(0), 0);
}

/// Of points of two balls, at poses whose axes are not quite orthogonal.
TEST(Leases, boundEveryPairOfPoints) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p = random.vector(1), q = random.vector(0.5);
    const Ball first{random.vector(1), 0}, second{random.vector(0.5), 0};
    const auto at = [&](Eigen::Affine3d pose) {
      pose.linear() += Eigen::Matrix3d::Ones() * random.sign() * random.magnitude(-17, -11);
      return pose;
    };
    const auto holding = [](const Ball& ball, const Eigen::Vector3d& point) {
      return Ball(ball.center, (point - ball.center).norm() * (1 + 1e-15));
    };
    const Eigen::Affine3d a0 = at(random.rigid(2)), b0 = at(random.rigid(2));
    const Eigen::Affine3d a1 = at(a0 * step(random)), b1 = at(b0 * step(random));
    const auto placed = [&](const Ball& ball, const Eigen::Vector3d& point,
                            const Eigen::Affine3d& pose) {
      return *rigidBody(holding(ball, point), pose);
    };
    const double then = (a0 * p - b0 * q).norm(), now = (a1 * p - b1 * q).norm();
    const BodyDistance found{
        then, then, a0 * p, b0 * q, (b0 * q - a0 * p) / then, DistanceLevel::kHull};
    const RigidBody p0 = placed(first, p, a0), q0 = placed(second, q, b0);
    const Lease lease(found, PosePair(p0, q0), p0, q0);
    const RigidBody p1 = placed(first, p, a1), q1 = placed(second, q, b1);
    const BodyDistance carried = lease.carried(lease.motion(PosePair(p1, q1), p1, q1), p1, q1);
    ASSERT_LE(carried.lower, now);
    ASSERT_GE(carried.upper, now);
  }
}

/// Of a box with its center in the origin of its frame.
double support(const Eigen::Vector3d& size, const Eigen::Affine3d& pose, const Eigen::Vector3d& n) {
  return n.dot(pose.translation()) + (pose.linear().transpose() * n).cwiseAbs().dot(size) / 2;
}

/// Of a small body at a large one, as a tool at a floor: where one of the two turns.
TEST(Leases, TheNormalProvesWhatIsCarried) {
  Random random(3);
  const std::array<Eigen::Vector3d, 2> sizes{Eigen::Vector3d(0.01, 0.02, 0.01),
                                             Eigen::Vector3d(30, 30, 0.1)};
  int carried = 0, tried = 0;
  for (int sequence = 0; sequence < repetitions(200); ++sequence) {
    const std::size_t small = random.sign() > 0 ? 0 : 1;
    BodyDistances distances({1e-3});
    std::array<Eigen::Vector3d, 2> size;
    std::array<Eigen::Affine3d, 2> pose;
    for (const std::size_t i : {small, 1 - small}) {
      size[i] = sizes[i == small ? 0 : 1];
      pose[i] = random.rigid(0);
      auto body = std::make_shared<Body>();
      body->shapes.push_back({{nullptr, Solid::kBox, size[i], Eigen::Affine3d::Identity()}});
      distances.set(i, body);
    }
    pose[small].translation() = pose[1 - small].linear() * Eigen::Vector3d(0, 0, 0.2);
    for (int i = 0; i < 20; ++i) {
      const std::size_t moved = random.uniform(0, 10) < 1 ? 1 - small : small;
      pose[moved].rotate(Eigen::AngleAxisd(random.magnitude(-5, moved == small ? -2 : -5),
                                           random.vector(1).normalized()));
      for (const std::size_t k : {0u, 1u})
        distances.move(k, pose[k]);
      const auto fresh = distances.findOnce(0, 1, kInfinity);
      const auto found = distances.follow(0, 1);
      ASSERT_TRUE(found && found->lower > 0);
      const Eigen::Vector3d n = found->normal;
      const double gap = -support(size[1], pose[1], -n) - support(size[0], pose[0], n);
      EXPECT_GE(gap, found->lower - 1e-12);
      carried += found->lower != fresh->lower;
      ++tried;
    }
  }
  EXPECT_GT(carried, tried / 4);
}

/// A link of some balls in a row.
std::shared_ptr<const Body> row(std::size_t balls, double radius) {
  auto result = std::make_shared<Body>();
  for (std::size_t i = 0; i < balls; ++i) {
    BodyShape ball;
    ball.shape.solid = Solid::kEllipsoid;
    ball.shape.size.setConstant(2 * radius);
    ball.shape.link_from_shape.translation().y() = static_cast<double>(i);
    result->shapes.push_back(ball);
  }
  return result;
}

TEST(Leases, ASetThatThrowsChangesNothing) {
  Random random(9);
  BodyDistances distances({1e-6});
  const Eigen::Affine3d at(Eigen::Translation3d(9, 0.3, 0));
  const std::shared_ptr<const Body> still = row(1, 0.5);
  distances.set(1, still);
  distances.move(1, at);
  std::shared_ptr<const Body> body;
  int failures = 0;
  for (int i = 0; i < repetitions(3000); ++i) {
    const auto other = row(static_cast<std::size_t>(random.uniform(1, 9)), random.uniform(0.1, 4));
    replaced_new::until_failure = static_cast<long>(random.uniform(0, 40));
    try {
      distances.set(0, other);
      body = other;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    replaced_new::until_failure = -1;
    if (!body) continue;
    distances.move(0, kIdentity);
    const BodyDistance found = *distances.find(0, 1);
    const BodyDistance plain = *bodyDistance(*body, kIdentity, *still, at, {1e-6});
    ASSERT_LE(found.lower, plain.upper) << i;
    ASSERT_GE(found.upper, plain.lower) << i;
  }
  EXPECT_GT(failures, repetitions(3000) / 4);
  EXPECT_LT(failures, repetitions(3000) * 9 / 10);
}

}  // namespace
}  // namespace link_bounds

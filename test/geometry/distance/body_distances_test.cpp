// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of updates against a computation without memory.
#include "link_bounds/geometry/distance/body_distances.h"

#include <gtest/gtest.h>

#include <utility>

#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr std::size_t kBodies = 5;

/// 1e-10 is for rounding.
bool reaches(const DistanceGoal& goal, const BodyDistance& found) {
  return found.lower >= goal.limit ||
         found.upper - found.lower <= goal.tolerance(found.upper) + 1e-10;
}

/// Both bounds are proven, so they must fit those of another proof.
void expectSame(const std::optional<BodyDistance>& found, const Twin& a, const Twin& b,
                const DistanceGoal& goal) {
  const bool is_known = a.body && b.body && a.pose && b.pose;
  const auto fresh = is_known ? bodyDistance(*a.body, *a.pose, *b.body, *b.pose, goal)
                              : std::optional<BodyDistance>();
  ASSERT_EQ(found.has_value(), fresh.has_value());
  if (!found) return;
  ASSERT_LE(found->lower, fresh->upper);
  ASSERT_LE(fresh->lower, found->upper);
  ASSERT_EQ(reaches(goal, *found), reaches(goal, *fresh))
      << found->lower << " " << found->upper << " " << fresh->lower << " " << fresh->upper;
}

void change(Twin& twin, std::size_t i, Random& random, BodyDistances& distances) {
  const int what = static_cast<int>(random.uniform(0, 60));
  if (what == 0 || !twin.body) {
    twin = {what == 0 ? nullptr : mixedBody(random, 0.7, false), std::nullopt};
    distances.set(i, twin.body);
    return;
  }
  const bool jumps = what < 5 || !twin.pose || !isUsablePose(*twin.pose);
  Eigen::Affine3d pose = jumps ? random.rigid(0.7) : *twin.pose;
  pose.translation() += random.vector(random.magnitude(-5, -1));
  pose.rotate(Eigen::AngleAxisd(random.magnitude(-5, -1), random.vector(1).normalized()));
  if (what == 1) pose(0, 3) = random.sign() * kInfinity;
  if (what == 2) pose(1, 1) = std::nan("");
  if (what == 3) pose(2, 3) = 1e300;
  twin.pose = pose;
  distances.move(i, pose);
}

TEST(BodyDistances, AgreeWithAComputationWithoutMemory) {
  Random random(1);
  for (int sequence = 0; sequence < repetitions(10); ++sequence) {
    DistanceGoal goal{random.magnitude(-5, -2),
                      random.sign() > 0 ? kInfinity : random.magnitude(-2, 0)};
    if (sequence % 2 == 1) goal.relative_accuracy = random.magnitude(-3, -0.5);
    BodyDistances distances(goal);
    std::vector<Twin> twins(kBodies);
    for (std::size_t i = 0; i < kBodies; ++i) {
      twins[i].body = mixedBody(random, 0.7, false);
      distances.set(i, twins[i].body);
    }
    for (int step = 0; step < 200; ++step) {
      for (std::size_t i = 0; i < kBodies; ++i) {
        if (random.sign() > 0) change(twins[i], i, random, distances);
      }
      if (step % 50 == 49) {
        goal.accuracy = random.magnitude(-5, -2);
        distances.setGoal(goal);
      }
      for (std::size_t i = 0; i < kBodies; ++i) {
        for (std::size_t j = 0; j < kBodies; ++j)
          expectSame(distances.find(i, j), twins[i], twins[j], goal);
      }
    }
  }
}

void expectSameInMotion(const MeshBody& a, const MeshBody& b, const Eigen::Vector3d& at,
                        const DistanceGoal& goal, Random& random) {
  BodyDistances distances(goal);
  std::vector<Twin> twins{{std::make_shared<Body>(a.body), Eigen::Affine3d::Identity()},
                          {std::make_shared<Body>(b.body), random.rigid(0)}};
  twins[1].pose->translation() = at;
  for (std::size_t i = 0; i < 2; ++i)
    distances.set(i, twins[i].body);
  const Eigen::Vector3d axis = random.vector(1).normalized();
  for (int step = 0; step < (kIsSanitized ? 70 : 100); ++step) {
    Eigen::Affine3d& pose = *twins[1].pose;
    pose.rotate(Eigen::AngleAxisd(random.magnitude(-4, -1.5), axis));
    pose.translation() += random.vector(random.magnitude(-5, -2.5));
    if (step % 60 == 59) pose.linear() = random.rotation();
    const Eigen::Matrix3d rigid = pose.linear();
    if (step % 10 == 3) pose.linear() *= random.uniform(1.1, 1.3);
    if (step % 5 == 0) twins[0].pose->rotate(Eigen::AngleAxisd(random.magnitude(-4, -2), axis));
    for (std::size_t i = 0; i < 2; ++i)
      distances.move(i, *twins[i].pose);
    const auto found = random.sign() > 0 ? distances.find(0, 1) : distances.follow(0, 1);
    expectSame(found, twins[0], twins[1], goal);
    const auto again = distances.find(0, 1);
    const bool is_reached = found->lower > goal.limit || found->lower >= goal.enough(found->upper);
    ASSERT_TRUE(again->lower == found->lower || !is_reached);
    pose.linear() = rigid;
    if (step != 50) continue;
    const auto exact = distance_oracle::distance(a.placed(*twins[0].pose), b.placed(pose));
    ASSERT_LE(distances.find(0, 1)->lower, exact);
    ASSERT_GE(distances.find(0, 1)->upper, exact);
  }
}

TEST(BodyDistances, AgreeInTheCoherentMotionOfMeshesWithBumps) {
  // Thousands of pairs of nodes are nearly as near as the nearest one, and are remembered.
  Random random(2);
  MeshBody a, b, shell;
  const std::uint32_t steps = kIsSanitized ? 8 : 16;
  a.add(bumpyBall(steps, 0.01));
  Eigen::Affine3d mirrored = random.rigid(0.1);
  mirrored.linear() *= Eigen::Vector3d(-1, 0.5, 2).asDiagonal();
  b.add(bumpyBall(steps, 0.01), mirrored);
  shell.add(bumpyBall(steps, 0.003), Eigen::Affine3d(Eigen::Scaling(1.2)));
  for (int i = 0; i < (kIsSanitized ? 1 : 2); ++i) {
    expectSameInMotion(a, b, {0.9, 0, 0}, {1e-5}, random);
    expectSameInMotion(a, a, {0.61, 0.1, 0}, {1e-6, 0.1}, random);
    expectSameInMotion(shell, a, {0.05, 0, 0}, {1e-4}, random);
    expectSameInMotion(a, b, {0.9, 0, 0}, {1e-9, kInfinity, 1'000'000, 0.02}, random);
    // Where steps run out, bounds are wider but hold.
    expectSameInMotion(shell, a, {0.05, 0, 0}, {1, kInfinity, 20}, random);
  }
}

TEST(BodyDistances, ARelativeAccuracyTakesFewerSteps) {
  MeshBody ball, shell;
  ball.add(bumpyBall(16, 0.01));
  shell.add(bumpyBall(16, 0.003), Eigen::Affine3d(Eigen::Scaling(1.2)));
  const Eigen::Affine3d rest = Eigen::Affine3d::Identity(),
                        inside(Eigen::Translation3d(0.02, 0.01, 0));
  const auto distance = [&](const DistanceGoal& goal) {
    return bodyDistance(shell.body, rest, ball.body, inside, goal).value();
  };
  const auto stepsNeeded = [&](DistanceGoal goal) {
    std::size_t too_few = 0, enough = 10'000;
    while (enough - too_few > 1) {
      goal.max_steps = (too_few + enough) / 2;
      (reaches(goal, distance(goal)) ? enough : too_few) = goal.max_steps;
    }
    return enough;
  };
  const BodyDistance exact = distance({1e-9});
  std::size_t steps = stepsNeeded({1e-9});
  for (const double part : {0.02, 0.3}) {
    DistanceGoal goal{1e-9, kInfinity, 10'000, part};
    const BodyDistance rough = distance(goal);
    EXPECT_LE(rough.upper - rough.lower, part * rough.upper + 1e-12);
    EXPECT_LE(rough.lower, exact.upper);
    EXPECT_GE(rough.upper, exact.lower);
    const std::size_t steps_before = std::exchange(steps, stepsNeeded(goal));
    EXPECT_LT(steps, steps_before);
  }
}

/// A full simplex is left where two bodies meet. Rounding may put its nearest point farther from
/// the origin than the accuracy.
TEST(BodyDistances, HoldWhereHugeBodiesMeet) {
  Random random(5);
  const std::vector<Eigen::Vector3d> sizes{{1e11, 1e11, 1e11}, {1e15, 1e15, 1e15}, {1e5, 1e5, 0.1},
                                           {1e4, 1e4, 1e-3},   {1e12, 1, 1},       {1, 1, 1}};
  int meetings = 0, tried = 0;
  for (const Eigen::Vector3d& size : sizes) {
    for (const Solid solid : {Solid::kBox, Solid::kEllipsoid, Solid::kCylinder}) {
      for (const double accuracy : {1e-4, 1e-15}) {
        BodyDistances distances({accuracy});
        auto huge = std::make_shared<Body>(), small = std::make_shared<Body>();
        huge->shapes.push_back({{nullptr, solid, size, Eigen::Affine3d::Identity()}});
        small->shapes.push_back(
            {{nullptr, Solid::kBox, Eigen::Vector3d(0.3, 0.2, 0.1), random.rigid(0.5)}});
        distances.set(0, huge);
        distances.set(1, small);
        distances.move(0, random.rigid(0.1));
        for (int i = 0; i < repetitions(300); ++i) {
          distances.move(1, random.rigid(1));
          const auto found = distances.follow(0, 1);
          ASSERT_TRUE(found && found->lower >= 0 && found->lower <= found->upper);
          meetings += found->lower == 0;
          ++tried;
        }
      }
    }
  }
  EXPECT_GT(meetings, tried / 10);
}

/// A simplex of four points in one plane has no volume, but may have been kept from a contact.
TEST(BodyDistances, FollowFlatPlatesThatMeetAndComeIntoOnePlane) {
  Random random(15);
  const Eigen::Affine3d identity = Eigen::Affine3d::Identity();
  for (int i = 0; i < repetitions(20000); ++i) {
    BodyDistances distances({1e-4});
    const Eigen::Vector3d first(random.uniform(0.1, 1), random.uniform(0.1, 1), 0);
    const Eigen::Vector3d second(random.uniform(0.1, 1), random.uniform(0.1, 1), 0);
    for (const auto& [index, size] : {std::pair{0, first}, {1, second}}) {
      const BodyShape plate{{nullptr, Solid::kBox, size, identity}};
      distances.set(static_cast<std::size_t>(index), std::make_shared<Body>(Body{{plate}}));
    }
    const Eigen::Affine3d pose = random.rigid(1);
    distances.move(0, pose);
    // Off their centres: of a symmetric contact two points remain.
    distances.move(1, pose * Eigen::Translation3d(random.vector(0.02)) *
                          Eigen::AngleAxisd(random.uniform(1, 2), Eigen::Vector3d::UnitX()));
    ASSERT_EQ(distances.find(0, 1)->lower, 0);
    const double gap = random.uniform(0.001, 0.1);
    const double turn = random.uniform(-0.01, 0.01);
    distances.move(1, pose * Eigen::Translation3d((first.x() + second.x()) / 2 + gap, 0, 0) *
                          Eigen::AngleAxisd(i % 2 ? turn : 0, Eigen::Vector3d::UnitX()));
    const BodyDistance apart = *distances.find(0, 1);
    ASSERT_LE(apart.lower, gap + 1e-12);
    ASSERT_GE(apart.upper, gap - 1e-12);
    ASSERT_LE(apart.upper - apart.lower, 1e-4 + 1e-12);
  }
}

/// Its pose maps the direction across it to nothing.
TEST(BodyDistances, FollowAFlatMeshBetweenManyBodies) {
  Random random(6);
  TriangleMesh wave;
  constexpr std::uint32_t kCells = 20;
  for (std::uint32_t i = 0; i <= kCells; ++i) {
    for (std::uint32_t j = 0; j <= kCells; ++j) {
      const auto x = static_cast<float>(i), y = static_cast<float>(j);
      wave.vertices.emplace_back(0.1f * x - 1, 0.1f * y - 1, 0.1f * std::sin(3 * x));
      const std::uint32_t at = i * (kCells + 1) + j;
      if (i == kCells || j == kCells) continue;
      wave.triangles.push_back({at, at + kCells + 1, at + 1});
      wave.triangles.push_back({at + 1, at + kCells + 1, at + kCells + 2});
    }
  }
  MeshBody plate;
  plate.add(wave, Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 0.0)));
  // Cubes on both sides, each a point that a box sweeps.
  std::vector<Eigen::Vector3d> centers;
  std::vector<std::array<std::uint32_t, 3>> points;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Eigen::Vector3d across(0, 0, random.sign() * random.uniform(0.2, 0.4));
    const double x = random.uniform(-0.9, 0.9), y = random.uniform(-0.9, 0.9);
    centers.push_back((across + Eigen::Vector3d(x, y, 0)).cast<float>().cast<double>());
    points.push_back({i, i, i});
  }
  std::vector<Eigen::Vector3f> corners;
  for (const Eigen::Vector3d& center : centers)
    corners.push_back(center.cast<float>());
  const Eigen::Vector3d size(0.05, 0.05, 0.05);
  const Shape swept{std::make_shared<const PointSet>(corners), Solid::kBox, size,
                    Eigen::Affine3d::Identity()};
  const Body cubes{{{swept, triangleTree(centers, points, Solid::kBox, size)}}};
  for (const std::size_t is_plate : {0u, 1u}) {
    const DistanceGoal goal{1e-4};
    BodyDistances distances(goal);
    distances.set(is_plate, std::make_shared<Body>(plate.body));
    distances.set(1 - is_plate, std::make_shared<Body>(cubes));
    distances.move(is_plate, Eigen::Affine3d::Identity());
    for (int i = 0; i < 20; ++i) {
      distances.move(1 - is_plate, Eigen::Affine3d(Eigen::Translation3d(1e-3 * i, 0, 1e-4 * i)));
      const auto found = distances.find(0, 1);
      ASSERT_TRUE(found);
      EXPECT_LE(found->upper - found->lower, goal.accuracy + 1e-10) << i;
    }
  }
}

TEST(BodyDistances, ForgetABodyThatIsReplaced) {
  MeshBody near, far;
  near.add(boxMesh({1, 1, 1}));
  far.add(boxMesh({1, 1, 1}), Eigen::Affine3d(Eigen::Translation3d(0, 0, 10)));
  BodyDistances distances;
  const Eigen::Affine3d still = Eigen::Affine3d::Identity();
  const Eigen::Affine3d beside(Eigen::Translation3d(2, 0, 0));
  distances.set(0, std::make_shared<Body>(near.body));
  distances.set(1, std::make_shared<Body>(near.body));
  EXPECT_FALSE(distances.find(0, 1));
  distances.move(0, still);
  distances.move(1, beside);
  EXPECT_NEAR(distances.find(0, 1)->lower, 1, 1e-9);
  distances.set(1, std::make_shared<Body>(far.body));
  EXPECT_FALSE(distances.find(0, 1));
  distances.move(1, beside);
  EXPECT_NEAR(distances.find(0, 1)->lower, std::sqrt(1 + 81), 1e-4);
  distances.set(1, nullptr);
  EXPECT_FALSE(distances.find(0, 1));
  EXPECT_FALSE(distances.find(0, 7));
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of updates against a computation without memory.
#include "link_bounds/geometry/distance/body_distances.h"

#include <gtest/gtest.h>

#include "testing/distance_bodies.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr std::size_t kBodies = 5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const Body> anyBody(Random& random) {
  auto body = std::make_shared<Body>();
  const int shapes = static_cast<int>(random.uniform(0.7, 4));
  for (int i = 0; i < shapes; ++i) {
    MeshBody mesh;
    mesh.add(anyMesh(random, 0.3), random.rigid(0.3));
    body->shapes.push_back(mesh.body.shapes[0]);
    if (random.sign() > 0) continue;
    body->shapes.back().triangles = nullptr;
    body->shapes.back().shape = {nullptr, Solid::kCylinder, random.vector(0.5).cwiseAbs(),
                                 random.rigid(0.3)};
  }
  return body;
}

/// What the class should know.
struct Twin {
  std::shared_ptr<const Body> body;
  std::optional<Eigen::Affine3d> pose;
};

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
  ASSERT_EQ(found->lower < goal.limit && found->upper - found->lower > goal.accuracy + 1e-10,
            fresh->lower < goal.limit && fresh->upper - fresh->lower > goal.accuracy + 1e-10)
      << found->lower << " " << found->upper << " " << fresh->lower << " " << fresh->upper;
}

void change(Twin& twin, std::size_t i, Random& random, BodyDistances& distances) {
  const int what = static_cast<int>(random.uniform(0, 60));
  if (what == 0 || !twin.body) {
    twin = {what == 0 ? nullptr : anyBody(random), std::nullopt};
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
  for (int sequence = 0; sequence < 10; ++sequence) {
    DistanceGoal goal{random.magnitude(-5, -2),
                      random.sign() > 0 ? kInfinity : random.magnitude(-2, 0)};
    BodyDistances distances(goal);
    std::vector<Twin> twins(kBodies);
    for (std::size_t i = 0; i < kBodies; ++i) {
      twins[i].body = anyBody(random);
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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is kept from one update to the next changes no box.
#include <gtest/gtest.h>

#include "link_bounds/geometry/shape/link_boxes.h"
#include "testing/brute_force.h"

namespace link_bounds {
namespace {

using brute_force::turned;

Shape meshShape(std::uint64_t seed, Solid solid = Solid::kNone) {
  brute_force::Random random(seed);
  return {std::make_shared<const PointSet>(random.points(300, 0.5)), solid,
          solid == Solid::kNone ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(0.1, 0.2, 0.3),
          Eigen::Affine3d::Identity()};
}

/// The box with memory, which must equal that without.
Aabb expectSame(const Shape& shape, const Eigen::Affine3d& pose, ShapeReach& reach) {
  const std::optional<Aabb> fresh = worldBox(shape, pose);
  const std::optional<Aabb> kept = placedBox(shape, pose, reach);
  EXPECT_EQ(fresh.has_value(), kept.has_value());
  if (!fresh || !kept) return Aabb();
  EXPECT_EQ(kept->min(), fresh->min());
  EXPECT_EQ(kept->max(), fresh->max());
  return *kept;
}

/// Recognisable memory: it can only be in a box if it was kept.
void poison(ShapeReach& reach, int row) {
  reach.range.low[row] = -100 - row;
}

bool isPoisoned(const Shape& shape, const Eigen::Affine3d& pose, ShapeReach reach, int row) {
  const Aabb box = placedBox(shape, pose, reach).value();
  return box.min()[row] < pose.translation()[row] - 50;
}

TEST(ShapeReach, OnlyTheTranslationIsAppliedWhileTheShapeDoesNotTurn) {
  const Shape shape = meshShape(1);
  ShapeReach reach(shape);
  Eigen::Affine3d pose(turned(30, {1, 2, 3}));
  expectSame(shape, pose, reach);
  for (int i = 0; i < 10; ++i) {
    pose.pretranslate(Eigen::Vector3d(0.1, -0.2, 1e5));
    expectSame(shape, pose, reach);
  }
  for (int row = 0; row < 3; ++row) {
    ShapeReach poisoned = reach;
    poison(poisoned, row);
    EXPECT_TRUE(isPoisoned(shape, pose, poisoned, row)) << "row " << row << " was not kept";
  }
}

TEST(ShapeReach, OneRowChangedKeepsTheOthers) {
  const Shape shape = meshShape(2);
  for (int changed = 0; changed < 3; ++changed) {
    for (int other = 0; other < 3; ++other) {
      ShapeReach reach(shape);
      Eigen::Affine3d pose(turned(45, {1, -2, 3}));
      expectSame(shape, pose, reach);
      poison(reach, other);
      pose.linear().row(changed) *= 1.5;
      EXPECT_EQ(isPoisoned(shape, pose, reach, other), other != changed);
    }
  }
}

TEST(ShapeReach, TurnsAboutAnAxisOfTheWorldKeepThatRow) {
  for (const Solid solid : {Solid::kNone, Solid::kBox, Solid::kEllipsoid, Solid::kCylinder}) {
    const Shape shape = meshShape(3, solid);
    ShapeReach reach(shape);
    for (int degrees = 0; degrees < 720; degrees += 15) {
      const Eigen::Affine3d pose(turned(degrees, Eigen::Vector3d::UnitZ()));
      expectSame(shape, pose, reach);
      poison(reach, 2);
      EXPECT_TRUE(isPoisoned(shape, pose, reach, 2));
      reach = ShapeReach(shape);
    }
  }
}

TEST(ShapeReach, OppositeQuaternionsAreTheSameRotation) {
  const Shape shape = meshShape(4);
  brute_force::Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Quaterniond q(random.rotation());
    const Eigen::Quaterniond opposite(-q.w(), -q.x(), -q.y(), -q.z());
    ShapeReach reach(shape);
    expectSame(shape, Eigen::Affine3d(q), reach);
    for (int row = 0; row < 3; ++row) {
      ShapeReach poisoned = reach;
      poison(poisoned, row);
      EXPECT_TRUE(isPoisoned(shape, Eigen::Affine3d(opposite), poisoned, row));
    }
  }
}

TEST(ShapeReach, AnyOrderOfPosesGivesTheSameBoxes) {
  const Shape shape = meshShape(5);
  brute_force::Random random(5);
  std::vector<Eigen::Affine3d> poses{Eigen::Affine3d::Identity()};
  for (int i = 0; i < 6; ++i) {
    poses.push_back(random.affine(1));
    poses.push_back(poses.back());
    poses.back().linear().row(i % 3) = poses.front().linear().row(i % 3);
  }
  ShapeReach reach(shape);
  for (int i = 0; i < 3000; ++i)
    expectSame(shape, poses[static_cast<std::size_t>(random.uniform(0, 13))], reach);
}

TEST(ShapeReach, AnUnusablePoseInBetweenLeavesNoTrace) {
  const Shape shape = meshShape(6);
  ShapeReach reach(shape);
  const Eigen::Affine3d good(turned(30, {1, 0, 1}));
  for (const double bad : {std::nan(""), HUGE_VAL, 2e30}) {
    expectSame(shape, good, reach);
    Eigen::Affine3d pose = good;
    pose.linear()(1, 2) = bad;
    EXPECT_FALSE(placedBox(shape, pose, reach));
    pose.linear().setConstant(bad);
    EXPECT_FALSE(placedBox(shape, pose, reach));
    pose = good;
    pose.translation().x() = std::nan("");
    EXPECT_FALSE(placedBox(shape, pose, reach));
    expectSame(shape, good, reach);
  }
}

// The first mesh has no box out of reach, so the second one is not placed there at all.
TEST(LinkReach, APoseOutOfReachInBetweenLeavesNoTrace) {
  const BoundedLink link{"l", {meshShape(9), meshShape(10)}, 0, ""};
  LinkReach reach(link);
  const Eigen::Affine3d near(turned(30, {1, 0, 1}));
  Eigen::Affine3d far(turned(70, {1, 2, 3}));
  far.translation().x() = HUGE_VAL;
  for (const Eigen::Affine3d& pose : {near, far, near}) {
    std::optional<Aabb> box;
    updateLinkBoxes({{&link, &pose, &reach, &box}});
    const std::optional<Aabb> fresh = linkBox(link, pose);
    ASSERT_EQ(box.has_value(), fresh.has_value());
    if (!fresh) continue;
    EXPECT_EQ(box->min(), fresh->min());
    EXPECT_EQ(box->max(), fresh->max());
  }
}

TEST(LinkReach, EachShapeHasItsOwn) {
  const BoundedLink link{"l", {meshShape(7), meshShape(8, Solid::kBox)}, 0.1, ""};
  LinkReach reach(link);
  brute_force::Random random(7);
  for (int i = 0; i < 100; ++i) {
    Eigen::Affine3d pose = random.rigid(1);
    for (int j = 0; j < 3; ++j) {
      const Aabb fresh = linkBox(link, pose).value();
      const Aabb kept = linkBox(link, pose, reach).value();
      EXPECT_EQ(kept.min(), fresh.min());
      EXPECT_EQ(kept.max(), fresh.max());
      pose.pretranslate(random.vector(1));
    }
  }
}

// Many at once, then one alone, in poses that turn fully, about one axis, or not at all.
TEST(ShapeReach, ManyLinksAtOnceAreThoseOneByOne) {
  const BoundedLink first{"first", {meshShape(5), meshShape(6, Solid::kBox)}, 0, ""};
  const BoundedLink second{"second", {meshShape(7)}, 0.1, ""};
  LinkReach reaches[] = {LinkReach(first), LinkReach(second)};
  brute_force::Random random(8);
  for (int i = 0; i < 60; ++i) {
    Eigen::Affine3d pose(random.rigid(1));
    if (i % 3 == 1) pose.linear().setIdentity();
    if (i % 3 == 2) pose.linear() = turned(30, {0, 0, 1});
    std::optional<Aabb> boxes[2];
    updateLinkBoxes(
        {{&first, &pose, &reaches[0], &boxes[0]}, {&second, &pose, &reaches[1], &boxes[1]}});
    EXPECT_EQ(boxes[0]->min(), linkBox(first, pose)->min());
    EXPECT_EQ(boxes[0]->max(), linkBox(first, pose)->max());
    EXPECT_EQ(boxes[1]->min(), linkBox(second, pose)->min());
    const Eigen::Affine3d other(random.rigid(1));
    EXPECT_EQ(linkBox(second, other, reaches[1])->max(), linkBox(second, other)->max());
  }
}

}  // namespace
}  // namespace link_bounds

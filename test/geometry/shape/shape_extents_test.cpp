// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The extents that are kept from one update to the next change no box.
#include "geometry/shape/shape_extents.h"

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

std::optional<Aabb> placedBox(const Shape& shape, const Eigen::Affine3d& pose,
                              ShapeExtents& known) {
  std::optional<Aabb> box(std::in_place);
  if (!placeShape(shape, pose, nullptr, known, *box)) box.reset();
  return box;
}

/// The box with memory, which must equal that without.
Aabb expectSame(const Shape& shape, const Eigen::Affine3d& pose, ShapeExtents& known) {
  const std::optional<Aabb> fresh = worldBox(shape, pose);
  const std::optional<Aabb> kept = placedBox(shape, pose, known);
  EXPECT_EQ(fresh.has_value(), kept.has_value());
  if (!fresh || !kept) return Aabb();
  EXPECT_EQ(kept->min(), fresh->min());
  EXPECT_EQ(kept->max(), fresh->max());
  return *kept;
}

/// Recognisable memory: it can only be in a box if it was kept.
void poison(ShapeExtents& known, int row) {
  known.extents.low[row] = -100 - row;
}

bool isPoisoned(const Shape& shape, const Eigen::Affine3d& pose, ShapeExtents known, int row) {
  const Aabb box = placedBox(shape, pose, known).value();
  return box.min()[row] < pose.translation()[row] - 50;
}

TEST(ShapeExtents, OnlyTheTranslationIsAppliedWhileTheShapeDoesNotTurn) {
  const Shape shape = meshShape(1);
  ShapeExtents known(shape);
  Eigen::Affine3d pose(turned(30, {1, 2, 3}));
  expectSame(shape, pose, known);
  for (int i = 0; i < 10; ++i) {
    pose.pretranslate(Eigen::Vector3d(0.1, -0.2, 1e5));
    expectSame(shape, pose, known);
  }
  for (int row = 0; row < 3; ++row) {
    ShapeExtents poisoned = known;
    poison(poisoned, row);
    EXPECT_TRUE(isPoisoned(shape, pose, poisoned, row)) << "row " << row << " was not kept";
  }
}

TEST(ShapeExtents, OneRowChangedKeepsTheOthers) {
  const Shape shape = meshShape(2);
  for (int changed = 0; changed < 3; ++changed) {
    for (int other = 0; other < 3; ++other) {
      ShapeExtents known(shape);
      Eigen::Affine3d pose(turned(45, {1, -2, 3}));
      expectSame(shape, pose, known);
      poison(known, other);
      pose.linear().row(changed) *= 1.5;
      EXPECT_EQ(isPoisoned(shape, pose, known, other), other != changed);
    }
  }
}

TEST(ShapeExtents, TurnsAboutAnAxisOfTheWorldKeepThatRow) {
  for (const Solid solid : {Solid::kNone, Solid::kBox, Solid::kEllipsoid, Solid::kCylinder}) {
    const Shape shape = meshShape(3, solid);
    ShapeExtents known(shape);
    for (int degrees = 0; degrees < 720; degrees += 15) {
      const Eigen::Affine3d pose(turned(degrees, Eigen::Vector3d::UnitZ()));
      expectSame(shape, pose, known);
      poison(known, 2);
      EXPECT_TRUE(isPoisoned(shape, pose, known, 2));
      known = ShapeExtents(shape);
    }
  }
}

TEST(ShapeExtents, OppositeQuaternionsAreTheSameRotation) {
  const Shape shape = meshShape(4);
  brute_force::Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Quaterniond q(random.rotation());
    const Eigen::Quaterniond opposite(-q.w(), -q.x(), -q.y(), -q.z());
    ShapeExtents known(shape);
    expectSame(shape, Eigen::Affine3d(q), known);
    for (int row = 0; row < 3; ++row) {
      ShapeExtents poisoned = known;
      poison(poisoned, row);
      EXPECT_TRUE(isPoisoned(shape, Eigen::Affine3d(opposite), poisoned, row));
    }
  }
}

TEST(ShapeExtents, AnUnusablePoseInBetweenLeavesNoTrace) {
  const Shape shape = meshShape(6);
  ShapeExtents known(shape);
  const Eigen::Affine3d good(turned(30, {1, 0, 1}));
  for (const double bad : {std::nan(""), HUGE_VAL, 2e30}) {
    expectSame(shape, good, known);
    Eigen::Affine3d pose = good;
    pose.linear()(1, 2) = bad;
    EXPECT_FALSE(placedBox(shape, pose, known));
    pose.linear().setConstant(bad);
    EXPECT_FALSE(placedBox(shape, pose, known));
    pose = good;
    pose.translation().x() = std::nan("");
    EXPECT_FALSE(placedBox(shape, pose, known));
    expectSame(shape, good, known);
  }
}

void expectBox(const LinkBoxes& boxes, std::size_t i, const BoundedLink& link,
               const Eigen::Affine3d& pose) {
  const std::optional<Aabb> fresh = linkBox(link, pose);
  ASSERT_EQ(boxes.box(i).has_value(), fresh.has_value());
  if (!fresh) return;
  EXPECT_EQ(boxes.box(i)->min(), fresh->min());
  EXPECT_EQ(boxes.box(i)->max(), fresh->max());
}

TEST(LinkBoxes, ThereIsNoBoxBeforeTheFirstPose) {
  const LinkBoxes boxes({{"l", {meshShape(1)}, 0, ""}});
  EXPECT_FALSE(boxes.box(0));
}

TEST(LinkBoxes, TheLinksMayGo) {
  const Eigen::Affine3d pose(turned(30, {1, 0, 1}));
  std::vector<BoundedLink> links{{"l", {meshShape(1)}, 0.1, ""}};
  LinkBoxes boxes(links);
  const BoundedLink kept{"l", {meshShape(1)}, 0.1, ""};
  links.clear();
  boxes.update(0, pose);
  expectBox(boxes, 0, kept, pose);
}

}  // namespace
}  // namespace link_bounds

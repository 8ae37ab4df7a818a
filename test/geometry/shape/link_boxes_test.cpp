// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One box around all shapes of a link.
#include "link_bounds/geometry/shape/link_boxes.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"
#include "testing/numbers.h"

namespace link_bounds {
namespace {

using brute_force::turned;

constexpr double kTolerance = 1e-12;  // metres

/// A tetrahedron that looks different in every orientation.
const std::vector<Eigen::Vector3f> kPoints{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};

Shape meshShape(const Eigen::Affine3d& link_from_shape) {
  return {std::make_shared<const PointSet>(kPoints), Solid::kNone, Eigen::Vector3d::Zero(),
          link_from_shape};
}

Shape ballShape(double diameter, const Eigen::Vector3d& center) {
  return {nullptr, Solid::kEllipsoid, Eigen::Vector3d::Constant(diameter),
          Eigen::Affine3d(Eigen::Translation3d(center))};
}

void expectBox(const std::optional<Aabb>& box, const Aabb& expected) {
  ASSERT_TRUE(box);
  EXPECT_LE((box->min() - expected.min()).cwiseAbs().maxCoeff(), kTolerance);
  EXPECT_LE((box->max() - expected.max()).cwiseAbs().maxCoeff(), kTolerance);
}

/// Yaw, pitch and roll as a URDF origin applies them, degrees.
Eigen::Matrix3d fromRpy(double roll, double pitch, double yaw) {
  return turned(yaw, Eigen::Vector3d::UnitZ()) * turned(pitch, Eigen::Vector3d::UnitY()) *
         turned(roll, Eigen::Vector3d::UnitX());
}

TEST(LinkBox, IsTheUnionOverShapesOfDifferentOrigins) {
  Eigen::Affine3d plain(turned(30, Eigen::Vector3d::UnitX()));
  plain.pretranslate(Eigen::Vector3d(0.1, 0.2, 0.3));
  Eigen::Affine3d mirrored(turned(45, Eigen::Vector3d(1, 2, 3)));
  mirrored.pretranslate(Eigen::Vector3d(-1, 0.5, 2)).scale(Eigen::Vector3d(1, -1, 1));
  const BoundedLink link{"l", {meshShape(plain), meshShape(mirrored)}, 0, ""};
  brute_force::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Affine3d world_from_link = random.rigid(2);
    Aabb expected = brute_force::box(kPoints, world_from_link * plain);
    expected.extend(brute_force::box(kPoints, world_from_link * mirrored));
    expectBox(linkBox(link, world_from_link), expected);
  }
}

TEST(LinkBox, ScaleMinusOneWithAnOddRpyMirrorsBeforeTurning) {
  Eigen::Affine3d origin(fromRpy(30, 45, 17));
  origin.scale(-1);
  const auto box = linkBox({"l", {meshShape(origin)}, 0, ""}, kIdentity);
  std::vector<Eigen::Vector3f> mirrored;
  for (const Eigen::Vector3f& point : kPoints)
    mirrored.push_back(-point);
  expectBox(box, brute_force::box(mirrored, Eigen::Affine3d(fromRpy(30, 45, 17))));
}

TEST(LinkBox, MeshesAndSolidsCountAlike) {
  const BoundedLink link{"l", {meshShape(kIdentity), ballShape(1, {0, 0, -4})}, 0, ""};
  expectBox(linkBox(link, kIdentity),
            Aabb(Eigen::Vector3d(-0.5, -0.5, -4.5), Eigen::Vector3d(1, 2, 3)));
}

TEST(LinkBox, PaddingIsAddedInTheWorldOnEverySide) {
  BoundedLink link{"l", {meshShape(kIdentity)}, 0, ""};
  const Eigen::Affine3d world_from_link(turned(45, Eigen::Vector3d(1, 1, 1)));
  Aabb expected = linkBox(link, world_from_link).value();
  link.padding = 0.25;
  expected.min().array() -= 0.25;
  expected.max().array() += 0.25;
  expectBox(linkBox(link, world_from_link), expected);
}

TEST(LinkBox, ALinkWithoutShapesHasNone) {
  EXPECT_FALSE(linkBox({"l", {}, 0.5, ""}, kIdentity));
}

TEST(LinkBox, ALinkThatIsNotWholeHasABoxOfWhatIsThere) {
  const BoundedLink link{"l", {ballShape(1, {0, 0, 0})}, 0, "visual 2: lost"};
  EXPECT_FALSE(link.isWhole());
  EXPECT_TRUE(linkBox(link, kIdentity));
}

TEST(Magnitude, CountsWhatCancelsOut) {
  Eigen::Affine3d far_and_back(Eigen::Translation3d(0, 0, -30));
  far_and_back.scale(10);
  EXPECT_DOUBLE_EQ(magnitude({"l", {meshShape(kIdentity)}, 0.5, ""}), 3);
  EXPECT_DOUBLE_EQ(magnitude({"l", {ballShape(1, {0, -4, 0}), meshShape(far_and_back)}, 0, ""}),
                   60);
  EXPECT_DOUBLE_EQ(magnitude({"l", {ballShape(1, {0, -4, 0})}, 0, ""}), 4.5);
  EXPECT_EQ(magnitude({"l", {}, 0, ""}), 0);
}

TEST(LinkBox, OneShapeWithoutABoxLeavesTheLinkWithoutOne) {
  Eigen::Affine3d unusable = kIdentity;
  unusable.linear()(0, 0) = 2e30;
  EXPECT_FALSE(linkBox({"l", {ballShape(1, {0, 0, 0}), meshShape(unusable)}, 0, ""}, kIdentity));
  EXPECT_FALSE(linkBox({"l", {meshShape(unusable), ballShape(1, {0, 0, 0})}, 0, ""}, kIdentity));
}

}  // namespace
}  // namespace link_bounds

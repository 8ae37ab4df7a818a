// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a box of joint values can move, against poses in it.
#include "robot/pairs/motion_bound.h"

#include <gtest/gtest.h>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/pairs/swept_search.h"
#include "testing/brute_force.h"
#include "testing/distance_bodies.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

Eigen::Vector3d directionOf(Random& random) {
  const Eigen::Vector3d any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
  return any.normalized();
}

Body ballAt(const Eigen::Vector3d& center, double radius) {
  Shape shape;
  shape.solid = Solid::kEllipsoid;
  shape.size.setConstant(2 * radius);
  shape.link_from_shape.translation() = center;
  return {{{shape}}};
}

/// Points of a body, and the cloud around them.
struct Points {
  std::vector<Eigen::Vector3d> points;
  Body body;
};

Points randomPoints(Random& random) {
  Points result;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d point = 0.3 * directionOf(random);
    result.points.push_back(point);
    result.body.shapes.push_back(ballAt(point, 0).shapes[0]);
  }
  return result;
}

Eigen::Isometry3d randomPose(Random& random) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(random.uniform(-3, 3), directionOf(random)).toRotationMatrix();
  pose.translation() = 0.4 * directionOf(random);
  return pose;
}

JointPath randomPath(Random& random, std::size_t joints) {
  JointPath path;
  for (std::size_t j = 0; j < joints; ++j) {
    const bool is_follower = j > 1 && random.uniform(0, 1) < 0.3;
    if (!is_follower) path.variables.push_back(j);
    const Motion motion = random.uniform(0, 1) < 0.7 ? Motion::kRotation : Motion::kTranslation;
    path.joints.push_back({randomPose(random), motion, directionOf(random),
                           path.variables.size() - 1, is_follower ? -1.5 : 1,
                           is_follower ? 0.2 : 0});
  }
  path.after = randomPose(random);
  path.length = 10;
  return path;
}

double distanceOf(const Points& first, const Points& second, const Eigen::Isometry3d& pose) {
  double nearest = 1e9;
  for (const Eigen::Vector3d& a : first.points) {
    for (const Eigen::Vector3d& b : second.points)
      nearest = std::min(nearest, (a - pose * b).norm());
  }
  return nearest;
}

PathValues valuesIn(const JointBox& box, Random& random) {
  PathValues values = box.center;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const double share = std::min(std::max(random.uniform(-1.5, 1.5), -1.0), 1.0);
    values[v] += share * box.half_widths[v];
  }
  return values;
}

TEST(MotionBound, NoPoseOfTheBoxContradictsIt) {
  Random random(7);
  int tight = 0;
  for (int i = 0; i < repetitions(3000); ++i) {
    const Points first = randomPoints(random), second = randomPoints(random);
    const JointPath path = randomPath(random, 1 + static_cast<std::size_t>(i) % 5);
    JointBox box;
    const double size = std::pow(10, random.uniform(-3, 0.5));
    for (std::size_t v = 0; v < path.variables.size(); ++v) {
      box.center.push_back(random.uniform(-3, 3));
      box.half_widths.push_back(size * random.uniform(0, 1));
    }
    const BodyCloud first_cloud(first.body), second_cloud(second.body);
    MotionBound bound(path, first_cloud, second_cloud);
    PlacedPath placed;
    path.place(box.center, placed);
    bound.set(box, placed);
    const double at_center = distanceOf(first, second, placed.first_from_second);
    const Eigen::Vector3d normal = directionOf(random);
    const double gap = bound.gapAlong(normal, first_cloud, second_cloud);
    PlacedPath other;
    for (int k = 0; k < 30; ++k) {
      path.place(valuesIn(box, random), other);
      const double distance = distanceOf(first, second, other.first_from_second);
      ASSERT_GE(distance, at_center - bound.motion() - bound.rounding()) << i;
      ASSERT_GE(distance, gap - bound.rounding()) << i;
      if (distance < at_center - bound.motion() / 2) ++tight;
    }
  }
  EXPECT_GT(tight, 0);
}

/// A ball that turns about z, and a point on the way of it.
TEST(MotionBound, IsTheChordOfTheFarthestPoint) {
  JointPath path;
  path.variables = {0};
  path.joints = {
      {Eigen::Isometry3d::Identity(), Motion::kRotation, Eigen::Vector3d::UnitZ(), 0, 1, 0}};
  const BodyCloud first(ballAt({0, 5, 0}, 1)), second(ballAt({1, 0, 7}, 0.25));
  MotionBound bound(path, first, second);
  PlacedPath placed;
  path.place({0.3}, placed);
  bound.set({{0.3}, {0.2}}, placed);
  EXPECT_NEAR(bound.motion(), 2 * std::sin(0.1) * 1.25, 1e-9);
  bound.set({{0.3}, {4}}, placed);
  EXPECT_NEAR(bound.motion(), 2 * 1.25, 1e-9);
}

/// The error of the bound along a direction falls with the square of the width.
TEST(MotionBound, AlongADirectionIsOfSecondOrder) {
  JointPath path;
  path.variables = {0};
  path.joints = {
      {Eigen::Isometry3d::Identity(), Motion::kRotation, Eigen::Vector3d::UnitZ(), 0, 1, 0}};
  const BodyCloud first(ballAt({0.5, 0, 0}, 0)), second(ballAt({1, 0, 0}, 0));
  MotionBound bound(path, first, second);
  PlacedPath placed;
  path.place({0}, placed);
  for (const double width : {0.1, 0.01}) {
    bound.set({{0}, {width}}, placed);
    const double gap = bound.gapAlong(Eigen::Vector3d::UnitX(), first, second);
    EXPECT_LE(gap, 0.5);
    EXPECT_NEAR(gap, 0.5 - 0.5 * width * width / 2, 1e-9);
  }
}

bool holds(const Body& cylinders, const Eigen::Vector3d& point) {
  return std::any_of(cylinders.shapes.begin(), cylinders.shapes.end(), [&](const BodyShape& it) {
    const Eigen::Vector3d local = it.shape.link_from_shape.inverse() * point;
    return 2 * local.head<2>().norm() <= it.shape.size.x() &&
           2 * std::abs(local.z()) <= it.shape.size.z();
  });
}

TEST(SweptBody, HoldsEachPointAtAnyAngle) {
  Random random(3);
  for (int i = 0; i < repetitions(100); ++i) {
    std::vector<Eigen::Vector3f> corners;
    for (int k = 0; k < 9; ++k)
      corners.push_back((directionOf(random) * random.uniform(0, 1)).cast<float>());
    MeshBody mesh;
    mesh.add(meshOf(corners), Eigen::Affine3d(randomPose(random)));
    const Points points = randomPoints(random);
    Body body = points.body;
    body.shapes.push_back(mesh.body.shapes[0]);
    const Eigen::Isometry3d pose = randomPose(random);
    Eigen::Vector3d axis = directionOf(random);
    // Many are nearly along z, as a program for drawing writes them.
    const double tilt = std::pow(10, random.uniform(-10, -2));
    if (i % 2 == 1) axis = (Eigen::Vector3d::UnitZ() * (i % 4 - 2) + tilt * axis).normalized();
    const Body swept = sweptBody(body, pose, axis);
    for (int k = 0; k < 300; ++k) {
      const std::size_t triangle = 3 * static_cast<std::size_t>(random.uniform(0, 2.99));
      const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
      Eigen::Vector3d point =
          body.shapes.back().shape.link_from_shape *
          (corners[triangle].cast<double>() * (1 - u - v) +
           corners[triangle + 1].cast<double>() * u + corners[triangle + 2].cast<double>() * v);
      if (k % 3 == 0) point = points.points[static_cast<std::size_t>(k) % points.points.size()];
      const Eigen::AngleAxisd turn(random.uniform(-4, 4), axis);
      ASSERT_TRUE(holds(swept, turn * (pose * point))) << i;
    }
  }
}

/// Two triangles that meet in a point on the axis.
TEST(SweptBody, IsNarrowWhereTheBodyIs) {
  MeshBody mesh;
  mesh.add(meshOf({{0, 0, 0}, {1, 0, 1}, {0.5, 0, 1}, {0, 0, 0}, {1, 0, -1}, {0.5, 0, -1}}));
  const Body swept = sweptBody(mesh.body, Eigen::Isometry3d::Identity(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(holds(swept, {0, 0.4, 0.5}));
  EXPECT_FALSE(holds(swept, {0, 0.6, 0.5}));
  EXPECT_TRUE(holds(swept, {0, 0.99, -1}));
  EXPECT_FALSE(holds(swept, {0, 1.01, -1}));
}

TEST(JointPath, IsThePoseOfTheSecondLinkInTheFrameOfTheFirst) {
  Random random(3);
  Robot robot;
  robot.links.resize(6);
  const std::size_t parents[] = {0, 1, 1, 3, 4};  // links 2 and 5 hang on link 1
  for (std::size_t i = 0; i < 5; ++i) {
    Joint joint{std::to_string(i),  parents[i],          i + 1, Motion::kRotation,
                randomPose(random), directionOf(random), {},    Limits{-2, 2}};
    if (i == 3) joint.motion = Motion::kTranslation;
    robot.joints.push_back(joint);
  }
  robot.joints[4].mimic = Mimic{"1", -0.5, 0.1};
  const std::vector<JointRange> ranges = jointRanges(robot, {{"2", {0.7, 0.7}}});
  const JointPath path = jointPath(robot, ranges, 2, 5);
  ASSERT_EQ(path.variables, (std::vector<std::size_t>{1, 3}));
  const std::vector<double> values =
      jointValues(robot, {{"0", 1.5}, {"1", 0.4}, {"2", 0.7}, {"3", -0.3}});
  const std::vector<Eigen::Isometry3d> poses = linkPoses(robot, values);
  PlacedPath placed;
  path.place({0.4, -0.3}, placed);
  EXPECT_LT((placed.first_from_second.matrix() - (poses[2].inverse() * poses[5]).matrix()).norm(),
            1e-12);
}

}  // namespace
}  // namespace link_bounds

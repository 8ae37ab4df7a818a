// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a marker draws has the distance that it has in rviz.
#include "world/moment/object_body.h"

#include <gtest/gtest.h>

#include "link_bounds/geometry/distance/body_distance.h"
#include "link_bounds/ros/messages.h"
#include "testing/marker_testing.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

constexpr double kTolerance = 1e-9;

ObjectContent contentOf(const Marker& marker) {
  ObjectContent content;
  MarkerShape shape = markerShape(Marker(marker));
  content.bounded = {"object", shape.shapes, 0, ""};
  content.drawing = shape.drawing;
  return content;
}

Marker listOf(int type, const Eigen::Vector3d& scale, const std::vector<Eigen::Vector3d>& points) {
  Marker marker = markerOf(type, scale);
  for (const Eigen::Vector3d& point : points)
    marker.points.push_back(toPoint(point));
  return marker;
}

/// The distance of the drawing and a point.
BodyDistance distanceTo(const Body& body, const Eigen::Vector3d& point) {
  Shape shape;
  shape.link_from_shape.translation() = point;
  const Eigen::Affine3d identity = Eigen::Affine3d::Identity();
  return bodyDistance(body, identity, {{{shape}}}, identity, {1e-10}).value();
}

void expectDistance(const Marker& marker, const Eigen::Vector3d& point, double expected) {
  const ObjectContent content = contentOf(marker);
  const auto tree = hasTree(content) ? listTree(content).triangles : nullptr;
  const BodyDistance found = distanceTo(objectBody(content, tree), point);
  EXPECT_LE(found.lower, expected + kTolerance) << marker.type;
  EXPECT_GE(found.upper, expected - kTolerance) << marker.type;
  EXPECT_LT(found.upper - found.lower, kTolerance) << marker.type;
}

TEST(ObjectBodyTest, solids) {
  expectDistance(markerOf(Marker::CUBE, {2, 4, 6}), {3, 0, 0}, 2);
  expectDistance(markerOf(Marker::SPHERE, {2, 2, 2}), {3, 4, 0}, 4);
  expectDistance(markerOf(Marker::CYLINDER, {2, 2, 6}), {0, 3, 2}, 2);
}

/// Shaft and cone, not the boxes around them.
TEST(ObjectBodyTest, arrowByPose) {
  const Marker arrow = markerOf(Marker::ARROW, {1, 0.1, 0.1});
  expectDistance(arrow, {2, 0, 0}, 1);
  expectDistance(arrow, {0.4, 1, 0}, 0.95);
  expectDistance(arrow, {0.77, 0, 1}, 0.9);
  const Eigen::Vector2d along = Eigen::Vector2d(0.23, -0.1).normalized();  // of the cone's side
  const Eigen::Vector2d beside =
      Eigen::Vector2d(0.885, 0.05) + Eigen::Vector2d(-along.y(), along.x());
  expectDistance(arrow, {beside.x(), beside.y(), 0}, 1);
}

TEST(ObjectBodyTest, arrowByPoints) {
  const Marker arrow = listOf(Marker::ARROW, {0.2, 0.4, 0.5}, {{1, 1, 1}, {1, 1, 3}});
  expectDistance(arrow, {1, 1, 4}, 1);
  expectDistance(arrow, {2, 1, 1.5}, 0.9);
  expectDistance(arrow, {1, 2, 2.5}, 0.8);
  expectDistance(arrow, {1, 1, 0}, 1);
}

/// Between two points of a list is nothing; its convex hull would be at 0.
TEST(ObjectBodyTest, listsHaveGaps) {
  const std::vector<Eigen::Vector3d> two{{0, 0, 0}, {4, 0, 0}};
  expectDistance(listOf(Marker::POINTS, {0.3, 0.4, 0}, two), {2, 0, 0}, 1.75);
  expectDistance(listOf(Marker::SPHERE_LIST, {2, 2, 2}, two), {2, 0, 0}, 1);
  expectDistance(listOf(Marker::CUBE_LIST, {2, 2, 2}, two), {2, 0, 0}, 1);
  const std::vector<Eigen::Vector3d> four{{0, 0, 0}, {0, 1, 0}, {4, 0, 0}, {4, 1, 0}};
  expectDistance(listOf(Marker::LINE_LIST, {0.5, 0, 0}, four), {2, 0.5, 0}, 1.75);
  const Marker strip = listOf(Marker::LINE_STRIP, {0.5, 0, 0}, {{0, 0, 0}, {0, 4, 0}, {4, 4, 0}});
  expectDistance(strip, {2, 1, 0}, 1.75);
  expectDistance(strip, {3, 2, 0}, 1.75);
  expectDistance(listOf(Marker::TRIANGLE_LIST, {1, 1, 1},
                        {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {4, 0, 0}, {4, 1, 0}, {4, 0, 1}}),
                 {2, 0.1, 0.1}, 2);
}

/// Without the tree a list is known to lie in its hull: never too far, and the upper bound belongs
/// to a point of it.
TEST(ObjectBodyTest, withoutATreeTheHullCounts) {
  const ObjectContent content =
      contentOf(listOf(Marker::SPHERE_LIST, {2, 2, 2}, {{0, 0, 0}, {4, 0, 0}}));
  const BodyDistance found = distanceTo(objectBody(content, nullptr), {2, 0, 0});
  EXPECT_EQ(found.lower, 0);
  EXPECT_GE(found.upper, 1);
}

TEST(ObjectBodyTest, aScaleMayFlattenAList) {
  expectDistance(listOf(Marker::TRIANGLE_LIST, {1, 0, 2}, {{0, 1, 0}, {1, 2, 0}, {0, 3, 1}}),
                 {0, 1, 3}, std::sqrt(2.0));
}

}  // namespace
}  // namespace link_bounds

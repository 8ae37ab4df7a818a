// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of markers against samples of what rviz draws: they contain every sample, and reach beyond
// them no farther than samples can be missing.
#include "world/bodies/marker_shape.h"

#include <gtest/gtest.h>

#include "link_bounds/ros/messages.h"
#include "testing/marker_testing.h"

namespace link_bounds {
namespace {

using brute_force::turned;
using visualization_msgs::Marker;
using Samples = std::vector<Eigen::Vector3d>;

constexpr int kSteps = 180;           // samples around a circle
constexpr double kTolerance = 1e-12;  // of the size of what is drawn
/// What samples of a circle or a sphere may miss of its radius: 1 - cos(half a step), twice.
const double kSamplingLoss = 2 * (1 - std::cos(M_PI / kSteps));

Eigen::Vector3d scaleOf(const Marker& marker) {
  return {marker.scale.x, marker.scale.y, marker.scale.z};
}

Eigen::Vector3d vectorOf(const geometry_msgs::Point& p) {
  return {p.x, p.y, p.z};
}

Samples cube() {
  Samples result;
  for (int i = 0; i < 8; ++i)
    result.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
  return result;
}

/// A circle around the y axis, as the axis of rviz's cylinders and cones is.
Samples circle(double y) {
  Samples result;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = 2 * M_PI * i / kSteps;
    result.emplace_back(0.5 * std::cos(angle), y, 0.5 * std::sin(angle));
  }
  return result;
}

Samples cylinder() {
  Samples result = circle(-0.5);
  const Samples top = circle(0.5);
  result.insert(result.end(), top.begin(), top.end());
  return result;
}

Samples cone() {
  Samples result = circle(-0.5);
  result.emplace_back(0, 0.5, 0);
  return result;
}

Samples sphere() {
  Samples result;
  for (int i = 0; i <= kSteps / 2; ++i) {
    const double angle = 2 * M_PI * i / kSteps;
    for (const Eigen::Vector3d& rim : circle(0)) {
      result.emplace_back(rim * std::sin(angle) + Eigen::Vector3d(0, 0.5 * std::cos(angle), 0));
    }
  }
  return result;
}

Samples mapped(const Samples& samples, const Eigen::Affine3d& map) {
  Samples result;
  for (const Eigen::Vector3d& sample : samples)
    result.push_back(map * sample);
  return result;
}

/// The scene graph of rviz: what a node does to what hangs below it.
Eigen::Affine3d node(const Eigen::Vector3d& position, const Eigen::Matrix3d& rotation,
                     const Eigen::Vector3d& scale) {
  Eigen::Affine3d result(Eigen::Translation3d(position) * rotation);
  return result.scale(scale);
}

/// Shaft and head below the node of an arrow, which lies along y.
Samples arrow(const Eigen::Affine3d& arrow_node, double shaft_length, double shaft_diameter,
              double head_length, double head_diameter) {
  const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
  const Eigen::Affine3d shaft =
      node({0, shaft_length / 2, 0}, straight, {shaft_diameter, shaft_length, shaft_diameter});
  const Eigen::Affine3d head =
      node({0, shaft_length, 0}, straight, {head_diameter, head_length, head_diameter});
  Samples result = mapped(cylinder(), arrow_node * shaft);
  const Samples tip = mapped(cone(), arrow_node * head * Eigen::Translation3d(0, 0.5, 0));
  result.insert(result.end(), tip.begin(), tip.end());
  return result;
}

/// From y to the direction, by way of rviz's "forward", which is -z.
Eigen::Matrix3d arrowRotation(const Eigen::Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(-Eigen::Vector3d::UnitZ(), direction) *
         turned(-90, Eigen::Vector3d::UnitX());
}

Samples drawnArrow(const Marker& marker) {
  const Eigen::Vector3d scale = scaleOf(marker);
  if (marker.points.empty()) {
    return arrow(
        node({0, 0, 0}, arrowRotation(Eigen::Vector3d::UnitX()), {scale.z(), scale.x(), scale.y()}),
        0.77, 1, 0.23, 2);
  }
  const Eigen::Vector3d along = vectorOf(marker.points[1]) - vectorOf(marker.points[0]);
  const double length = along.norm();
  const double head = scale.z() == 0 ? 0.23 * length : std::min(scale.z(), length);
  return arrow(node(vectorOf(marker.points[0]), arrowRotation(along), Eigen::Vector3d::Ones()),
               length - head, scale.x(), head, scale.y());
}

/// Each point with samples of what is drawn around it.
Samples swept(const Marker& marker, const Samples& around) {
  Samples result;
  for (const geometry_msgs::Point& point : marker.points) {
    for (const Eigen::Vector3d& sample : around)
      result.push_back(vectorOf(point) + sample);
  }
  return result;
}

/// In the frame of the marker's pose.
Samples drawn(const Marker& marker) {
  const Eigen::Vector3d scale = scaleOf(marker);
  const Eigen::Affine3d scaled(Eigen::Scaling(scale));
  // rviz puts the axis of its cylinder from y to z.
  const Eigen::Affine3d upright(scaled.linear() * turned(90, Eigen::Vector3d::UnitX()));
  const auto ball = [](double diameter) {
    return mapped(sphere(), Eigen::Affine3d(Eigen::Scaling(diameter)));
  };
  switch (marker.type) {
    case Marker::ARROW:
      return drawnArrow(marker);
    case Marker::CUBE:
      return mapped(cube(), scaled);
    case Marker::SPHERE:
      return mapped(sphere(), scaled);
    case Marker::CYLINDER:
      return mapped(cylinder(), upright);
    case Marker::CUBE_LIST:
      return swept(marker, mapped(cube(), scaled));
    case Marker::SPHERE_LIST:
      return swept(marker, mapped(sphere(), scaled));
    case Marker::LINE_STRIP:
    case Marker::LINE_LIST:
      return swept(marker, ball(scale.x()));
    case Marker::POINTS:
      return swept(marker, ball(std::sqrt(scale.x() * scale.x() + scale.y() * scale.y())));
    case Marker::TRIANGLE_LIST:
      return mapped(swept(marker, {Eigen::Vector3d::Zero()}), scaled);
    default:
      return {};
  }
}

void expectFits(const Marker& marker, const Eigen::Affine3d& header_from_marker,
                const Eigen::Affine3d& fixed_from_header) {
  const auto box = markerBox(marker, fixed_from_header);
  ASSERT_TRUE(box);
  Aabb samples;
  for (const Eigen::Vector3d& sample :
       mapped(drawn(marker), fixed_from_header * header_from_marker))
    samples.extend(sample);
  const double size = samples.sizes().maxCoeff() + samples.center().norm();
  EXPECT_TRUE(padded(*box, kTolerance * size).contains(samples));
  const double loss = kSamplingLoss * scaleOf(marker).norm() + kTolerance * size;
  EXPECT_LE((samples.min() - box->min()).maxCoeff(), loss);
  EXPECT_LE((box->max() - samples.max()).maxCoeff(), loss);
}

/// Turned by 30 and 45 degrees and at random, both the marker and its frame.
void expectFitsHoweverTurned(Marker marker) {
  brute_force::Random random(7);
  const Eigen::Affine3d tilted(Eigen::Translation3d(-3, 1, 2) * turned(30, {1, 1, 0}));
  std::vector<Eigen::Matrix3d> rotations{Eigen::Matrix3d::Identity()};
  for (const double degrees : {30.0, 45.0}) {
    for (int axis = 0; axis < 3; ++axis)
      rotations.push_back(turned(degrees, Eigen::Vector3d::Unit(axis)));
    rotations.push_back(turned(degrees, {1, 2, 3}));
  }
  for (int i = 0; i < 5; ++i)
    rotations.push_back(random.rotation());
  for (const Eigen::Matrix3d& rotation : rotations) {
    Eigen::Isometry3d pose(rotation);
    pose.translation() = random.vector(5);
    setPose(marker, pose, random.magnitude(-2, 2));
    SCOPED_TRACE(testing::Message() << "type " << marker.type << " turned by\n" << rotation);
    expectFits(marker, pose, Eigen::Affine3d::Identity());
    expectFits(marker, pose, tilted);
  }
}

void expectBox(const Marker& marker, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  const auto box = markerBox(marker);
  ASSERT_TRUE(box);
  EXPECT_LE((box->min() - min).cwiseAbs().maxCoeff(), kTolerance) << box->min().transpose();
  EXPECT_LE((box->max() - max).cwiseAbs().maxCoeff(), kTolerance) << box->max().transpose();
}

Marker withPoints(Marker marker, const Samples& points) {
  for (const Eigen::Vector3d& point : points)
    marker.points.push_back(toPoint(point));
  return marker;
}

const Eigen::Vector3d kScale(0.3, 0.5, 1.1);

TEST(MarkerShape, CubesSpheresAndCylindersFit) {
  for (const int type : {Marker::CUBE, Marker::SPHERE, Marker::CYLINDER})
    expectFitsHoweverTurned(markerOf(type, kScale));
}

TEST(MarkerShape, ListsOfCubesAndSpheresFit) {
  for (const int type : {Marker::CUBE_LIST, Marker::SPHERE_LIST}) {
    expectFitsHoweverTurned(markerOf(type, kScale, 1));
    expectFitsHoweverTurned(markerOf(type, kScale, 6));
  }
}

TEST(MarkerShape, LinesAndPointsFit) {
  for (const int type : {Marker::LINE_STRIP, Marker::LINE_LIST, Marker::POINTS})
    expectFitsHoweverTurned(markerOf(type, kScale, 6));
}

TEST(MarkerShape, TrianglesFit) {
  expectFitsHoweverTurned(markerOf(Marker::TRIANGLE_LIST, kScale, 3));
  expectFitsHoweverTurned(markerOf(Marker::TRIANGLE_LIST, kScale, 30));
}

TEST(MarkerShape, ArrowsByPoseFit) {
  expectFitsHoweverTurned(markerOf(Marker::ARROW, kScale));
  expectFitsHoweverTurned(markerOf(Marker::ARROW, {2, 0.1, 0.4}));
}

TEST(MarkerShape, ArrowsByPointsFit) {
  for (const Eigen::Vector3d& scale :
       {Eigen::Vector3d(0.1, 0.2, 0), Eigen::Vector3d(0.1, 0.2, 0.3),
        Eigen::Vector3d(0.3, 0.1, 0.2), Eigen::Vector3d(0.1, 0.2, 100)}) {
    SCOPED_TRACE(scale.transpose());
    for (const Eigen::Vector3d& tip :
         {Eigen::Vector3d(2, 1, 0), Eigen::Vector3d(1, 1, 5), Eigen::Vector3d(1, 1, -4)})
      expectFitsHoweverTurned(withPoints(markerOf(Marker::ARROW, scale), {{1, 1, 0}, tip}));
  }
}

TEST(MarkerShape, AnArrowByPoseLiesAlongX) {
  expectBox(markerOf(Marker::ARROW, {2, 0.1, 0.3}), {0, -0.1, -0.3}, {2, 0.1, 0.3});
}

TEST(MarkerShape, AnArrowByPointsEndsAtThem) {
  expectBox(withPoints(markerOf(Marker::ARROW, {0.1, 0.4, 0.5}), {{1, 2, 3}, {1, 2, 7}}),
            {0.8, 1.8, 3}, {1.2, 2.2, 7});
}

TEST(MarkerShape, AnArrowNearlyDownwardsLosesNoDigits) {
  // Where the quaternion between two opposite directions would lose half of them.
  for (const double tilt : {0.0, 1e-8, 1e-6, 1e-4}) {
    const Eigen::Vector3d tip(tilt, 0, -1);
    expectBox(withPoints(markerOf(Marker::ARROW, {0, 0, 0}), {{0, 0, 0}, tip}), {0, 0, -1},
              {tilt, 0, 0});
  }
}

TEST(MarkerShape, AnArrowBetweenEqualPointsIsADisc) {
  expectBox(withPoints(markerOf(Marker::ARROW, {0.1, 0.4, 0.5}), {{1, 2, 3}, {1, 2, 3}}),
            {0.8, 1.8, 3}, {1.2, 2.2, 3});
}

TEST(MarkerShape, ScaleMultipliesThePointsOfTrianglesOnly) {
  const Samples points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  expectBox(withPoints(markerOf(Marker::TRIANGLE_LIST, {2, 3, 4}), points), {0, 0, 0}, {2, 3, 4});
  expectBox(withPoints(markerOf(Marker::CUBE_LIST, {2, 4, 6}), points), {-1, -2, -3}, {2, 3, 4});
}

TEST(MarkerShape, LinesAndPointsHaveTheirOwnUseOfScale) {
  const Samples points{{1, 1, 1}, {2, 2, 2}};
  expectBox(withPoints(markerOf(Marker::LINE_LIST, {0.2, 9, 9}), points), {0.9, 0.9, 0.9},
            {2.1, 2.1, 2.1});
  expectBox(withPoints(markerOf(Marker::POINTS, {0.6, 0.8, 9}), points), {0.5, 0.5, 0.5},
            {2.5, 2.5, 2.5});
}

TEST(MarkerShape, FlatSheetsGiveFlatBoxes) {
  const Samples sheet{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 1, 1}};
  expectBox(withPoints(markerOf(Marker::TRIANGLE_LIST, {1, 1, 1}), sheet), {0, 0, 1}, {1, 1, 1});
  expectBox(markerOf(Marker::CUBE, {1, 2, 0}), {-0.5, -1, 0}, {0.5, 1, 0});
}

TEST(MarkerShape, AMeshWaitsForItsPoints) {
  Marker marker = markerOf(Marker::MESH_RESOURCE, {2, 3, 4});
  Eigen::Isometry3d pose(turned(30, Eigen::Vector3d::UnitZ()));
  pose.translation().x() = 1;
  setPose(marker, pose);
  MarkerShape shape = markerShape(Marker(marker));
  EXPECT_EQ(shape.mesh_uri, marker.mesh_resource);
  ASSERT_EQ(shape.shapes.size(), 1u);
  EXPECT_EQ(shape.shapes[0].points, nullptr);
  const std::vector<Eigen::Vector3f> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
  shape.shapes[0].points = std::make_shared<const PointSet>(vertices);
  const auto box = linkBox({"marker", shape.shapes, 0, ""}, Eigen::Affine3d::Identity());
  ASSERT_TRUE(box);
  const double c = std::sqrt(3.0) / 2;
  EXPECT_LE((box->min() - Eigen::Vector3d(1 - 1.5, 0, 0)).norm(), kTolerance);
  EXPECT_LE((box->max() - Eigen::Vector3d(1 + 2 * c, 3 * c, 4)).norm(), kTolerance);
}

TEST(MarkerShape, OnlyMeshesHaveAUri) {
  Marker marker = markerOf(Marker::CUBE, kScale);
  marker.mesh_resource = "file:///part.stl";
  EXPECT_EQ(markerShape(Marker(marker)).mesh_uri, "");
}

TEST(MarkerPose, AZeroQuaternionIsTheIdentity) {
  Marker marker = markerOf(Marker::CUBE, kScale);
  marker.pose.orientation.w = 0;
  marker.pose.position = toPoint({1, 2, 3});
  EXPECT_EQ(markerPose(marker).linear(), Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  EXPECT_EQ(markerPose(marker).translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(MarkerPose, QuaternionsOfAnyLengthAreNormalised) {
  const Eigen::Matrix3d rotation = turned(30, {1, 2, 3});
  for (const double length : {1.0, 0.1, 7.0, 1e-300, 1e-320, 1e300, 1.7e308}) {
    Marker marker = markerOf(Marker::CUBE, kScale);
    setPose(marker, Eigen::Isometry3d(rotation), length);
    // The smallest numbers have few digits.
    const double tolerance = length < 1e-307 ? 1e-3 : 1e-14;
    EXPECT_LE((markerPose(marker).linear() - rotation).norm(), tolerance) << length;
  }
}

}  // namespace
}  // namespace link_bounds

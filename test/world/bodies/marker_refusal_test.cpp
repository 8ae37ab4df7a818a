// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each reason to refuse a marker alone; and whatever is not refused gets a finite box.
#include "world/bodies/marker_refusal.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "link_bounds/ros/messages.h"
#include "testing/marker_testing.h"
#include "testing/numbers.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

/// One of each type that has a shape.
std::vector<Marker> goodMarkers() {
  const Eigen::Vector3d scale(0.5, 1, 2);
  return {markerOf(Marker::ARROW, scale),
          markerOf(Marker::ARROW, scale, 2),
          markerOf(Marker::CUBE, scale),
          markerOf(Marker::SPHERE, scale),
          markerOf(Marker::CYLINDER, scale),
          markerOf(Marker::LINE_STRIP, scale, 3),
          markerOf(Marker::LINE_LIST, scale, 4),
          markerOf(Marker::CUBE_LIST, scale, 1),
          markerOf(Marker::SPHERE_LIST, scale, 5),
          markerOf(Marker::POINTS, scale, 7),
          markerOf(Marker::TRIANGLE_LIST, scale, 6),
          markerOf(Marker::MESH_RESOURCE, scale)};
}

/// `reason` must name the field and have a remedy after a semicolon.
void expectRefused(const Marker& marker, const std::string& field) {
  const std::string reason = whyMarkerRefused(marker);
  EXPECT_EQ(reason.rfind(field, 0), 0u) << reason << " for type " << marker.type;
  EXPECT_NE(reason.find("; "), std::string::npos) << reason;
}

void expectRefusedOfAll(const std::function<void(Marker&)>& spoil, const std::string& field) {
  for (Marker marker : goodMarkers()) {
    spoil(marker);
    expectRefused(marker, field);
  }
}

TEST(MarkerRefusal, GoodMarkersAreNotRefused) {
  for (const Marker& marker : goodMarkers()) {
    EXPECT_EQ(whyMarkerRefused(marker), "") << marker.type;
    EXPECT_TRUE(hasShape(marker));
  }
}

TEST(MarkerRefusal, AnEmptyFrame) {
  expectRefusedOfAll([](Marker& marker) { marker.header.frame_id.clear(); }, "header.frame_id");
}

/// A publisher that writes the bytes itself can send one.
TEST(MarkerRefusal, AStampThatIsNoTime) {
  const std::pair<std::uint32_t, std::uint32_t> wrong[] = {
      {UINT32_MAX, 0}, {UINT32_MAX - 10, 0}, {5, 1000000000}};
  for (const auto& time : wrong) {
    const auto spoil = [&time](Marker& marker) {
      marker.header.stamp.sec = time.first;
      marker.header.stamp.nsec = time.second;
    };
    expectRefusedOfAll(spoil, "header.stamp");
    Marker following = goodMarkers().front();
    spoil(following);
    following.frame_locked = true;  // then its stamp says nothing
    EXPECT_EQ(whyMarkerRefused(following), "");
  }
  Marker last = goodMarkers().front();
  last.header.stamp.sec = UINT32_MAX - 11;
  last.header.stamp.nsec = 999999999;
  EXPECT_EQ(whyMarkerRefused(last), "");
}

TEST(MarkerRefusal, AFrameThatIsASlash) {
  expectRefusedOfAll([](Marker& marker) { marker.header.frame_id = "/"; }, "header.frame_id");
}

TEST(MarkerRefusal, UnknownActions) {
  for (const int action : {1, 4, -1, 1000}) {
    expectRefusedOfAll([action](Marker& marker) { marker.action = action; },
                       "action " + std::to_string(action));
  }
}

TEST(MarkerRefusal, UnknownTypes) {
  for (const int type : {-1, 12, 1000, std::numeric_limits<int>::min()}) {
    Marker marker = markerOf(Marker::CUBE, {1, 1, 1}, 6);
    marker.type = type;
    expectRefused(marker, "type " + std::to_string(type));
  }
}

TEST(MarkerRefusal, PosesThatAreNotFiniteOrTooLarge) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int k = 0; k < 7; ++k) {
      expectRefusedOfAll(
          [&](Marker& marker) {
            auto& position = marker.pose.position;
            auto& q = marker.pose.orientation;
            double* const numbers[] = {&position.x, &position.y, &position.z, &q.x,
                                       &q.y,        &q.z,        &q.w};
            *numbers[k] = bad;
          },
          "pose");
    }
  }
  for (const double bad : {1e30, -1e300})
    expectRefusedOfAll([&](Marker& marker) { marker.pose.position.y = bad; }, "pose");
}

TEST(MarkerRefusal, ScalesThatAreNotFiniteOrTooLargeOrNegative) {
  for (const double bad : {kNan, kInfinity, 1e30, 1e300, -kInfinity, -1e-9, -1.0}) {
    expectRefusedOfAll([&](Marker& marker) { marker.scale.x = bad; }, "scale");
    expectRefusedOfAll([&](Marker& marker) { marker.scale.y = bad; }, "scale");
    expectRefusedOfAll([&](Marker& marker) { marker.scale.z = bad; }, "scale");
  }
}

TEST(MarkerRefusal, OnePointThatIsNotFiniteOrTooLarge) {
  for (const Marker& good : goodMarkers()) {
    for (std::size_t i = 0; i < good.points.size(); ++i) {
      for (const double bad : {kNan, kInfinity, -kInfinity, 1e30, -1e300}) {
        for (double geometry_msgs::Point::*axis :
             {&geometry_msgs::Point::x, &geometry_msgs::Point::y, &geometry_msgs::Point::z}) {
          Marker marker = good;
          marker.points[i].*axis = bad;
          expectRefused(marker, "points");
        }
      }
    }
  }
}

TEST(MarkerRefusal, WrongNumbersOfPoints) {
  const auto expect = [](int type, const std::vector<std::size_t>& wrong,
                         const std::vector<std::size_t>& right) {
    for (const std::size_t count : wrong)
      expectRefused(markerOf(type, {1, 1, 1}, count),
                    "points has " + std::to_string(count) + " element");
    for (const std::size_t count : right)
      EXPECT_EQ(whyMarkerRefused(markerOf(type, {1, 1, 1}, count)), "") << type << " " << count;
  };
  expect(Marker::ARROW, {1, 3, 4}, {0, 2});
  expect(Marker::LINE_STRIP, {0, 1}, {2, 3});
  expect(Marker::LINE_LIST, {0, 1, 3}, {2, 4});
  expect(Marker::TRIANGLE_LIST, {0, 1, 2, 4}, {3, 6});
  for (const int type : {Marker::CUBE_LIST, Marker::SPHERE_LIST, Marker::POINTS})
    expect(type, {0}, {1, 2});
}

/// Some remove a marker by sending it empty.
TEST(MarkerRefusal, AnEmptyListNamesDelete) {
  for (const int type :
       {Marker::CUBE_LIST, Marker::LINE_STRIP, Marker::LINE_LIST, Marker::TRIANGLE_LIST})
    expectRefused(
        markerOf(type, {1, 1, 1}, 0),
        "points has 0 elements; a list needs at least 1; to remove the marker, send DELETE");
}

TEST(MarkerRefusal, AMeshWithoutAName) {
  Marker marker = markerOf(Marker::MESH_RESOURCE, {1, 1, 1});
  marker.mesh_resource.clear();
  expectRefused(marker, "mesh_resource");
}

TEST(MarkerRefusal, WhatIsNotDrawnDoesNotMatter) {
  for (Marker marker : goodMarkers()) {
    marker.color.r = marker.color.a = std::numeric_limits<float>::quiet_NaN();
    marker.colors.resize(3, marker.color);
    EXPECT_EQ(whyMarkerRefused(marker), "");
  }
  for (const int type : {Marker::CUBE, Marker::SPHERE, Marker::CYLINDER, Marker::MESH_RESOURCE}) {
    Marker marker = markerOf(type, {1, 1, 1}, 1);
    marker.points[0].x = kNan;
    EXPECT_EQ(whyMarkerRefused(marker), "");
    EXPECT_EQ(markerShape(Marker(marker)).shapes.size(), 1u);
  }
}

TEST(MarkerRefusal, TextIsIgnoredWhateverItHolds) {
  Marker marker = markerOf(Marker::TEXT_VIEW_FACING, {kNan, -1, 1e300}, 1);
  marker.points[0].x = kNan;
  marker.header.frame_id.clear();
  EXPECT_EQ(whyMarkerRefused(marker), "");
  EXPECT_FALSE(hasShape(marker));
}

TEST(MarkerRefusal, TheLargestNumbersGiveFiniteBoxes) {
  constexpr double kLargest = 1e29;
  brute_force::Random random(1);
  for (Marker marker : goodMarkers()) {
    marker.scale.x = marker.scale.y = marker.scale.z = kLargest;
    for (geometry_msgs::Point& point : marker.points)
      point = toPoint({kLargest, -kLargest, random.sign() * kLargest});
    for (int i = 0; i < 100; ++i) {
      Eigen::Isometry3d pose(random.rotation());
      pose.translation().setConstant(kLargest);
      setPose(marker, pose);
      ASSERT_EQ(whyMarkerRefused(marker), "");
      const auto box = markerBox(marker, Eigen::Affine3d(random.rotation()));
      ASSERT_TRUE(box) << marker.type;
      ASSERT_TRUE(box->min().allFinite() && box->max().allFinite());
    }
  }
}

TEST(MarkerRefusal, ZeroScaleIsFlatAndNotRefused) {
  for (Marker marker : goodMarkers()) {
    for (const double zero : {0.0, -0.0}) {
      marker.scale.x = marker.scale.y = marker.scale.z = zero;
      EXPECT_EQ(whyMarkerRefused(marker), "");
      EXPECT_TRUE(markerBox(marker));
    }
  }
}

}  // namespace
}  // namespace link_bounds

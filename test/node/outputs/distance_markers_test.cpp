// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A line per pair, a thicker one and a number for the nearest; nothing is left behind.
#include "node/outputs/markers/distance_markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kRed = 0.1;
constexpr double kLimit = 0.3;
constexpr std::size_t kLines = 0;
constexpr std::size_t kText = 1;
constexpr std::size_t kNearest = 2;

Distance pairAt(double distance, double x) {
  Distance pair;
  pair.first = "arm";
  pair.second = "post/0";
  pair.distance = distance;
  pair.distance_max = distance;
  pair.on_first.x = x;
  pair.on_second.x = x + distance;
  return pair;
}

MarkerArray markersOf(const std::vector<Distance>& pairs) {
  DistanceArray array;
  array.header.frame_id = "base";
  array.distances = pairs;
  const auto nearest =
      std::min_element(pairs.begin(), pairs.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return distanceMarkers(array, nearest == pairs.end() ? Distance() : *nearest, kRed, kLimit);
}

TEST(DistanceMarkers, EachPairHasItsLine) {
  const MarkerArray array = markersOf({pairAt(0.25, 1), pairAt(0.125, 2)});
  const Marker& lines = array.markers[kLines];
  EXPECT_EQ(lines.type, Marker::LINE_LIST);
  EXPECT_EQ(lines.header.frame_id, "base");
  ASSERT_EQ(lines.points.size(), 4U);
  ASSERT_EQ(lines.colors.size(), 4U);
  EXPECT_EQ(lines.points[0].x, 1);
  EXPECT_EQ(lines.points[1].x, 1.25);
  EXPECT_EQ(lines.points[2].x, 2);
  EXPECT_EQ(lines.points[3].x, 2.125);
}

TEST(DistanceMarkers, NearestIsThickerAndHasItsNumber) {
  const MarkerArray array = markersOf({pairAt(0.25, 1), pairAt(0.125, 2)});
  const Marker& nearest = array.markers[kNearest];
  ASSERT_EQ(nearest.points.size(), 2U);
  EXPECT_EQ(nearest.points[0].x, 2);
  EXPECT_GE(nearest.scale.x, 2 * array.markers[kLines].scale.x);
  EXPECT_EQ(array.markers[kText].text, "0.12 m");
  EXPECT_EQ(array.markers[kText].pose.position.x, 2.0625);
  EXPECT_EQ(markersOf({pairAt(0.0625, 1)}).markers[kText].text, "0.062 m");
}

TEST(DistanceMarkers, RedIsNearAndGreenIsFar) {
  const auto colorAt = [](double distance) {
    return markersOf({pairAt(distance, 0)}).markers[kLines].colors[1];
  };
  for (const double distance : {0.0, kRed}) {
    EXPECT_EQ(colorAt(distance).r, 1);
    EXPECT_EQ(colorAt(distance).g, 0);
  }
  EXPECT_EQ(colorAt(kLimit).r, 0);
  EXPECT_GT(colorAt(kLimit).g, 0.5);
}

TEST(DistanceMarkers, WithoutPairsAllAreDeleted) {
  const MarkerArray before = markersOf({pairAt(0.2, 0)});
  const MarkerArray after = markersOf({});
  ASSERT_EQ(before.markers.size(), after.markers.size());
  for (std::size_t i = 0; i < after.markers.size(); ++i) {
    EXPECT_EQ(before.markers[i].action, Marker::ADD) << i;
    EXPECT_EQ(after.markers[i].action, Marker::DELETE) << i;
    EXPECT_EQ(after.markers[i].ns, before.markers[i].ns) << i;
    EXPECT_EQ(after.markers[i].id, before.markers[i].id) << i;
  }
}

TEST(DistanceMarkers, WhatRvizCannotDrawIsLeftOut) {
  for (const Marker& marker : markersOf({pairAt(0.2, 1e30)}).markers)
    EXPECT_EQ(marker.action, Marker::DELETE);
}

}  // namespace
}  // namespace link_bounds

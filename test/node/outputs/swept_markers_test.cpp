// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces and edges of all boxes in two markers; nothing is left behind.
#include "node/outputs/markers/swept_markers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kFaces = 0;
constexpr std::size_t kEdges = 1;

AxisAlignedBox boxAt(double x, double size) {
  AxisAlignedBox box;
  box.min.x = x;
  box.max.x = x + size;
  box.max.y = 2 * size;
  box.max.z = 3 * size;
  return box;
}

AxisAlignedBoxArray arrayOf(const std::vector<AxisAlignedBox>& boxes) {
  AxisAlignedBoxArray array;
  array.header.frame_id = "base";
  array.boxes = boxes;
  return array;
}

double distance(const geometry_msgs::Point& a, const geometry_msgs::Point& b) {
  return std::hypot(std::hypot(a.x - b.x, a.y - b.y), a.z - b.z);
}

TEST(SweptMarkers, TrianglesCoverTheFaces) {
  const MarkerArray array = sweptMarkers(arrayOf({boxAt(5, 1)}));
  const Marker& faces = array.markers[kFaces];
  EXPECT_EQ(faces.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(faces.header.frame_id, "base");
  EXPECT_LT(faces.color.a, 1);
  ASSERT_EQ(faces.points.size(), 36U);
  double area = 0;
  for (std::size_t i = 0; i < faces.points.size(); i += 3) {
    const double a = distance(faces.points[i], faces.points[i + 1]);
    const double b = distance(faces.points[i + 1], faces.points[i + 2]);
    const double c = distance(faces.points[i + 2], faces.points[i]);
    const double half = (a + b + c) / 2;
    area += std::sqrt(half * (half - a) * (half - b) * (half - c));
  }
  EXPECT_NEAR(area, 2 * (1 * 2 + 2 * 3 + 3 * 1), 1e-9);
}

TEST(SweptMarkers, EachBoxHasItsEdges) {
  const MarkerArray array = sweptMarkers(arrayOf({boxAt(0, 1), boxAt(5, 2)}));
  const Marker& lines = array.markers[kEdges];
  EXPECT_EQ(lines.type, Marker::LINE_LIST);
  ASSERT_EQ(lines.points.size(), 48U);
  double length = 0;
  for (std::size_t i = 0; i < lines.points.size(); i += 2)
    length += distance(lines.points[i], lines.points[i + 1]);
  EXPECT_NEAR(length, 3 * 4 * (1 + 2 + 3), 1e-9);
}

TEST(SweptMarkers, WithoutBoxesAllIsDeleted) {
  for (const auto& boxes : {arrayOf({}), arrayOf({boxAt(1e300, 1)})}) {
    const MarkerArray array = sweptMarkers(boxes);
    ASSERT_EQ(array.markers.size(), 2U);
    for (const Marker& marker : array.markers)
      EXPECT_EQ(marker.action, Marker::DELETE);
  }
}

}  // namespace
}  // namespace link_bounds

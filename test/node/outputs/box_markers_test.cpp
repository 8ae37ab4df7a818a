// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Cubes contain their boxes; no marker is left behind, none is deleted twice.
#include "node/outputs/markers/box_markers.h"

#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

MarkerArray markersNamed(const std::vector<std::string>& names) {
  MarkerArray array;
  for (const std::string& name : names) {
    Marker marker;
    marker.ns = name;
    array.markers.push_back(marker);
  }
  return array;
}

std::vector<std::string> deleted(const MarkerArray& array) {
  std::vector<std::string> names;
  for (const Marker& marker : array.markers) {
    if (marker.action == Marker::DELETE) names.push_back(marker.ns);
  }
  return names;
}

/// The box of a cube marker from its centre and scale, without rounding.
QuadBox boxOf(const Marker& cube) {
  const auto side = [](double center, double scale, int sign) {
    return static_cast<Quad>(center) + sign * static_cast<Quad>(scale) / 2;
  };
  const auto& p = cube.pose.position;
  const auto& s = cube.scale;
  return {{side(p.x, s.x, -1), side(p.y, s.y, -1), side(p.z, s.z, -1)},
          {side(p.x, s.x, 1), side(p.y, s.y, 1), side(p.z, s.z, 1)}};
}

TEST(BoxMarkers, CubesContainTheBoxesOfTheMessage) {
  brute_force::Random random(1);
  TransformBuffer tf;
  Scene scene(tf);
  scene.adopt(modelOf("base", {meshLink("l", 1)}), ros::Time(1));
  for (int i = 0; i < 2000; ++i) {
    const ros::Time now(10 + i);
    const Eigen::Quaterniond turn(random.rotation());
    tf.add({edge("base", "l", now.toSec(), turn, random.vector(random.magnitude(-3, 6)))}, false,
           now);
    ASSERT_TRUE(scene.update(now));
    const Aabb box = scene.links.states()[0].box.value();
    const QuadBox cube = boxOf(boxMarkers(*momentOf(scene)).markers.front());
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      ASSERT_LE(cube.min[axis], static_cast<Quad>(box.min()[k]));
      ASSERT_GE(cube.max[axis], static_cast<Quad>(box.max()[k]));
      ASSERT_LE(static_cast<double>(cube.max[axis] - cube.min[axis]),
                box.sizes()[k] + 1e-15 * (1 + box.max().norm() + box.min().norm()));
    }
  }
}

TEST(ShownMarkers, DeletesWhatVanishedOnce) {
  ShownMarkers shown;
  const std_msgs::Header header;
  MarkerArray first = markersNamed({"a", "b"});
  shown.replaceBy(first, header);
  EXPECT_TRUE(deleted(first).empty());
  MarkerArray second = markersNamed({"a"});
  shown.replaceBy(second, header);
  EXPECT_EQ(deleted(second), std::vector<std::string>{"b"});
  MarkerArray third = markersNamed({"a"});
  shown.replaceBy(third, header);
  EXPECT_TRUE(deleted(third).empty());
}

/// Of a greeting, which one subscriber alone has heard.
TEST(ShownMarkers, DeletesWhatAGreetingShowed) {
  ShownMarkers shown;
  shown.add(markersNamed({"a", "b"}));
  MarkerArray first = markersNamed({"a"});
  shown.replaceBy(first, std_msgs::Header());
  EXPECT_EQ(deleted(first), std::vector<std::string>{"b"});
}

TEST(ShownMarkers, DeletesAllWhereADeleteMayBeLost) {
  ShownMarkers shown;
  const std_msgs::Header header;
  MarkerArray first = markersNamed({"a", "b"});
  shown.replaceBy(first, header);
  MarkerArray second = markersNamed({"a"});
  shown.replaceBy(second, header, true);
  EXPECT_EQ(second.markers.front().action, visualization_msgs::Marker::DELETEALL);
  EXPECT_EQ(second.markers.front().ns, "link_bounds/") << "another node keeps what is not ours";
  EXPECT_TRUE(deleted(second).empty());
  MarkerArray third = markersNamed({});
  shown.replaceBy(third, header);
  EXPECT_EQ(deleted(third), std::vector<std::string>{"a"}) << "the first marker comes after it";
}

}  // namespace
}  // namespace link_bounds

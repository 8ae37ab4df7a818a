// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Deletions: no marker is left behind, none is deleted twice.
#include "box_markers.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

MarkerArray arrayOf(const std::vector<std::string>& names) {
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

TEST(ShownMarkers, DeletesWhatVanishedOnce) {
  ShownMarkers shown;
  const std_msgs::Header header;
  MarkerArray first = arrayOf({"a", "b"});
  shown.replaceBy(first, header);
  EXPECT_TRUE(deleted(first).empty());
  MarkerArray second = arrayOf({"a"});
  shown.replaceBy(second, header);
  EXPECT_EQ(deleted(second), std::vector<std::string>{"b"});
  MarkerArray third = arrayOf({"a"});
  shown.replaceBy(third, header);
  EXPECT_TRUE(deleted(third).empty());
}

TEST(ShownMarkers, ANewSubscriberTakesNoDeletionFromTheOthers) {
  ShownMarkers shown;
  const std_msgs::Header header;
  MarkerArray all = arrayOf({"a", "b"});
  shown.replaceBy(all, header);
  MarkerArray for_one = arrayOf({"a"});
  shown.extendBy(for_one, header);
  MarkerArray for_all = arrayOf({"a"});
  shown.replaceBy(for_all, header);
  EXPECT_EQ(deleted(for_all), std::vector<std::string>{"b"});
}

TEST(ShownMarkers, WhatOnlyANewSubscriberSawIsDeletedToo) {
  ShownMarkers shown;
  const std_msgs::Header header;
  MarkerArray for_one = arrayOf({"a"});
  shown.extendBy(for_one, header);
  MarkerArray for_all = arrayOf({});
  shown.replaceBy(for_all, header);
  EXPECT_EQ(deleted(for_all), std::vector<std::string>{"a"});
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits of rviz, and functions that all markers use.
#pragma once

#include <visualization_msgs/Marker.h>

#include <array>
#include <string>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/ros/messages.h"

namespace link_bounds {

constexpr double kMaxDrawable = 1e18;  ///< squares of larger numbers overflow rviz's float32 [m]

inline bool isDrawable(const Aabb& box) {
  return box.min().cwiseAbs().maxCoeff() <= kMaxDrawable &&
         box.max().cwiseAbs().maxCoeff() <= kMaxDrawable;
}

inline std_msgs::ColorRGBA toColor(const std::array<double, 4>& rgba) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(rgba[0]);
  color.g = static_cast<float>(rgba[1]);
  color.b = static_cast<float>(rgba[2]);
  color.a = static_cast<float>(rgba[3]);
  return color;
}

/// A marker with action ADD.
inline visualization_msgs::Marker newMarker(const std_msgs::Header& header, const std::string& ns,
                                            int id, int type) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.frame_locked = true;
  return marker;
}

inline void appendEdges(const std::array<Eigen::Vector3d, 8>& corner,
                        visualization_msgs::Marker& lines) {
  for (const auto& edge : edges()) {
    for (const int number : edge)
      lines.points.push_back(toPoint(corner[static_cast<std::size_t>(number)]));
  }
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Markers to bound, and their boxes.
#pragma once

#include <optional>
#include <utility>

#include "link_bounds/geometry/shape/link_boxes.h"
#include "link_bounds/ros/messages.h"
#include "testing/brute_force.h"
#include "world/bodies/marker_shape.h"

namespace link_bounds {

/// With as many points around (1, 2, 3) as `points` says; not turned.
inline visualization_msgs::Marker markerOf(int type, const Eigen::Vector3d& scale,
                                           std::size_t points = 0) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = "frame";
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.scale = toVector3(scale);
  brute_force::Random random(points);
  for (std::size_t i = 0; i < points; ++i)
    marker.points.push_back(toPoint(Eigen::Vector3d(1, 2, 3) + random.vector(1)));
  if (type == visualization_msgs::Marker::MESH_RESOURCE) marker.mesh_resource = "file:///part.stl";
  return marker;
}

/// The quaternion gets an arbitrary length.
inline void setPose(visualization_msgs::Marker& marker, const Eigen::Isometry3d& pose,
                    double quaternion_length = 1) {
  const Eigen::Quaterniond q(pose.linear());
  marker.pose.position = toPoint(pose.translation());
  marker.pose.orientation.x = quaternion_length * q.x();
  marker.pose.orientation.y = quaternion_length * q.y();
  marker.pose.orientation.z = quaternion_length * q.z();
  marker.pose.orientation.w = quaternion_length * q.w();
}

/// As the node bounds it, in a fixed frame.
inline std::optional<Aabb> markerBox(
    visualization_msgs::Marker marker,
    const Eigen::Affine3d& fixed_from_header = Eigen::Affine3d::Identity()) {
  return linkBox({"marker", markerShape(std::move(marker)).shapes, 0, ""}, fixed_from_header);
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Boxes as messages and back. The only public header that needs ROS; no library contains it.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Vector3.h>

#include <string>

#include "link_bounds/AxisAlignedBox.h"
#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

inline geometry_msgs::Point toPoint(const Eigen::Vector3d& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

inline geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 vector;
  vector.x = v.x();
  vector.y = v.y();
  vector.z = v.z();
  return vector;
}

/// The box must not be empty. `stamp` is the time of the pose; 0 if nothing can move.
inline AxisAlignedBox toMessage(const std::string& name, const Aabb& box,
                                const ros::Time& stamp = ros::Time()) {
  AxisAlignedBox message;
  message.name = name;
  message.stamp = stamp;
  message.min = toPoint(box.min());
  message.max = toPoint(box.max());
  return message;
}

inline Aabb toAabb(const AxisAlignedBox& message) {
  return {Eigen::Vector3d(message.min.x, message.min.y, message.min.z),
          Eigen::Vector3d(message.max.x, message.max.y, message.max.z)};
}

}  // namespace link_bounds

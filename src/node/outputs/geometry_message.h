// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From Eigen to the messages of geometry_msgs.
#pragma once

#include <geometry_msgs/Point.h>

#include <Eigen/Core>

namespace link_bounds {

inline geometry_msgs::Point toPoint(const Eigen::Vector3d& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

inline Eigen::Vector3d toVector(const geometry_msgs::Point& point) {
  return {point.x, point.y, point.z};
}

}  // namespace link_bounds

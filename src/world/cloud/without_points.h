// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages without the points of the robot, and the points of the robot alone.
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "world/cloud/robot_points.h"

namespace link_bounds {

/// If organised, the points become NaN in x, y and z, and all else stays; if not, they are left
/// out, and the cloud has one row. `removed` must be in order.
void removePoints(const std::vector<RobotPoint>& removed, bool keep_organized,
                  sensor_msgs::PointCloud2& cloud);

/// Their ranges become NaN: not measured, so neither an obstacle nor free.
void removePoints(const std::vector<RobotPoint>& removed, sensor_msgs::LaserScan& scan);

/// Only these points, with all fields, in one row.
sensor_msgs::PointCloud2 onlyPoints(const std::vector<RobotPoint>& kept,
                                    const sensor_msgs::PointCloud2& cloud);

}  // namespace link_bounds

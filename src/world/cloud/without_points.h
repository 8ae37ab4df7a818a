// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Removes the points of the robot from messages, or keeps only these.
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "world/cloud/robot_points.h"

namespace link_bounds {

/// With keep_organized, x, y and z of the points become NaN, and all else stays. Otherwise the
/// points are removed, and the cloud gets one row. `removed` must be in the order of the cloud.
void removePoints(const std::vector<RobotPoint>& removed, bool keep_organized,
                  sensor_msgs::PointCloud2& cloud);

/// The ranges of the points become NaN: not measured, so neither an obstacle nor free.
void removePoints(const std::vector<RobotPoint>& removed, sensor_msgs::LaserScan& scan);

/// A cloud of only these points, with all fields, in one row.
sensor_msgs::PointCloud2 onlyPoints(const std::vector<RobotPoint>& kept,
                                    const sensor_msgs::PointCloud2& cloud);

}  // namespace link_bounds

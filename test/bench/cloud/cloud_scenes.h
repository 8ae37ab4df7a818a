// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds that rays measure of a robot in a room.
#pragma once

#include <memory>
#include <string>

#include "testing/scanned_robot.h"

namespace link_bounds::bench {

struct CloudScene {
  std::string name;
  std::unique_ptr<ScannedRobot> robot;
  sensor_msgs::PointCloud2 cloud;
};

constexpr double kPadding = 0.01;  // m

/// A depth camera of 640 x 480 a metre and a half before the robot, which fills much of the
/// picture. All points have the time of the header.
CloudScene depthCamera(const RobotFile& file);

/// A lidar of 128 lines and 260,096 points in 0.1 s, two and a half metres from the robot, whose
/// joints turn at 1 rad/s. Each column has its own time.
CloudScene lidar(const RobotFile& file);

}  // namespace link_bounds::bench

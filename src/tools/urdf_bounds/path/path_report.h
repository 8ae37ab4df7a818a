// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a robot collides on its way along the rows of a table, on standard output.
#pragma once

#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/request/joint_table.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// What stands around the robot.
struct PathObjects {
  Robot robot;           ///< one link per object
  BoundedRobot bounded;  ///< with bodies
};

/// Writes a verdict per segment. `bounded` has bodies; `given` has one value per joint of the robot
/// with simple joints. Throws UsageError for rows that are no path.
Outcome writePath(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const PathObjects& objects, const JointTable& table, const JointValues& given);

}  // namespace link_bounds

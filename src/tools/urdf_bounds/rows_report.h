// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes and distances of many rows of joint values, on standard output.
#pragma once

#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/joint_table.h"
#include "tools/urdf_bounds/urdf_bounds_options.h"

namespace link_bounds {

/// Reads the file of --poses, and warns of what is wrong with it. `simple` has simple joints.
/// Throws UsageError; with --strict also where anything is wrong.
JointTable readJointTable(const UrdfBoundsOptions& options, const Robot& simple);

/// What is the same in all rows of a table: the values that the command line gives.
using JointValues = std::vector<double>;

/// One value per joint of the robot in that row.
JointValues valuesOf(const JointTable& table, std::size_t row, JointValues given);

/// Writes the summary, and with --series each row. `given` has one value per joint.
Outcome writeRows(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const JointTable& table, const JointValues& given);

}  // namespace link_bounds

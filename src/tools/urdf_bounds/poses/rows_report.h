// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes and distances of many rows of joint values, on standard output.
#pragma once

#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/request/joint_table.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes the summary, and with --series each row. `given` has one value per joint.
Outcome writeRows(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const JointTable& table, const JointValues& given);

}  // namespace link_bounds

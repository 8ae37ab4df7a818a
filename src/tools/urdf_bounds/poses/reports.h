// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The reports of urdf_bounds, each written to standard output.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/poses/distance_table.h"
#include "tools/urdf_bounds/request/joint_table.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes the volume of each link in `frame`; for boxes also the box around all of them. `poses`
/// are those of all links of the robot in `frame`. Adds `distances` if there are any. Returns the
/// links whose volume or distance is missing or incomplete, with the reason.
Reasons writeReport(const UrdfBoundsOptions& options, const std::string& frame,
                    const BoundedRobot& bounded, const std::vector<Eigen::Isometry3d>& poses,
                    const std::optional<DistanceTable>& distances);

/// Writes the summary of all rows, and with --series each row. `given` has one value per joint.
Outcome writeRows(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const JointTable& table, const JointValues& given);

/// Writes for each link and for the robot a box that it never leaves.
Outcome writeReach(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges);

/// Writes a verdict per pair of links. `bounded` has bodies.
Outcome writePairs(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges);

/// Writes a verdict per segment. `bounded` and the objects around it have bodies; `given` has one
/// value per joint of the robot with simple joints. Throws UsageError for rows that are no path.
Outcome writePath(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const BoundedRobot& objects, const JointTable& table, const JointValues& given);

}  // namespace link_bounds

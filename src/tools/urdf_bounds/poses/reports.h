// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The reports, each on standard output: one per question that urdf_bounds answers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/poses/distance_table.h"
#include "tools/urdf_bounds/request/joint_table.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

struct PlacedLink {
  const BoundedLink* link;
  Eigen::Isometry3d frame_from_link;
};

/// Writes the volume that the options name of each link, in `frame`; of boxes also the one around
/// all. Adds `distances` if there are any. Returns the links whose volume or distance is missing or
/// does not cover everything, with the reason.
Reasons writeReport(const UrdfBoundsOptions& options, const std::string& frame,
                    const std::vector<PlacedLink>& links,
                    const std::optional<DistanceTable>& distances);

/// Writes the summary of all rows, and with --series each row. `given` has one value per joint.
Outcome writeRows(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const JointTable& table, const JointValues& given);

/// Writes a box per link that it never leaves, and one for the robot.
Outcome writeReach(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges);

/// Writes a verdict per pair of links. `bounded` has bodies.
Outcome writePairs(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges);

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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot are near each other, and how near.
#pragma once

#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/distance_table.h"

namespace link_bounds {

/// All pairs of links whose proven distance is at most `limit` [m], in the frame of `poses`, which
/// are those of all links of the robot. Links of one rigid body, and those that one movable joint
/// connects, are no pair. `bounded` has bodies.
DistanceTable linkDistances(const Robot& robot, const BoundedRobot& bounded,
                            const std::vector<Eigen::Isometry3d>& poses, double limit);

}  // namespace link_bounds

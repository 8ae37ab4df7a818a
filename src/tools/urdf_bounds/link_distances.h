// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot are near each other, and how near, with their names.
#pragma once

#include "robot/posed/posed_robot.h"
#include "tools/urdf_bounds/distance_table.h"

namespace link_bounds {

/// All pairs of links whose proven distance is at most `limit` [m], in the frame of the root link.
/// Links of one rigid body, and those that one movable joint connects, are no pair. `bounded`, of
/// which `posed` is, has bodies.
DistanceTable linkDistances(PosedRobot& posed, const BoundedRobot& bounded, double limit);

}  // namespace link_bounds

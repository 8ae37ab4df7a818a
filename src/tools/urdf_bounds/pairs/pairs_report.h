// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links can collide, on standard output.
#pragma once

#include "link_bounds/robot/robot_loader.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes a verdict per pair of links. `bounded` has bodies.
Outcome writePairs(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The rectangle that the robot covers on the ground, for costmap_2d.
#pragma once

#include <geometry_msgs/Polygon.h>

#include <optional>
#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"

namespace link_bounds {

/// The corners (min x, min y), (max x, min y), (max x, max y), (min x, max y) at z = 0 [m], rounded
/// outward to float32. `groups` is a message of ~groups. nullopt if its box robot is missing,
/// incomplete or too large for float32.
std::optional<geometry_msgs::Polygon> footprintOf(const AxisAlignedBoxArray& groups);

/// Why footprintOf() returns nullopt; "" if it returns a polygon.
std::string whyNoFootprint(const AxisAlignedBoxArray& groups);

}  // namespace link_bounds

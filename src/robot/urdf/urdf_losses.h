// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which geometry elements urdfdom dropped, and why.
#pragma once

#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/urdf/urdf_outline.h"

namespace link_bounds {

/// urdfdom reads <inertial>, then the visuals, then the collisions of a link, and stops at the
/// first element that it cannot parse. So it keeps the first `kept` elements of `purpose`; returns
/// the others with their reasons. `link_messages` are urdfdom's messages about this link.
std::vector<LostElement> lostElements(const LinkOutline& link, Purpose purpose, std::size_t kept,
                                      const std::string& link_messages);

}  // namespace link_bounds

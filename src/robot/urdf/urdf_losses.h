// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which geometry elements of a URDF urdfdom left out, and why.
#pragma once

#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/urdf/urdf_outline.h"

namespace link_bounds {

/// urdfdom reads the elements of a link in order, visuals first, and stops at the first thing it
/// cannot parse (an <inertial> comes before all), so what it keeps is the beginning of the list.
/// `kept` of the elements of `purpose` were kept; tells the fate of the others. `link_messages`
/// is what urdfdom said about this link.
std::vector<LostElement> lostElements(const LinkOutline& link, Purpose purpose, std::size_t kept,
                                      const std::string& link_messages);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robots whose links are measured.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"

namespace link_bounds::bench {

struct MeasuredRobot {
  std::string name;  ///< of its URDF file
  Robot robot;
  std::vector<BoundedLink> links;  ///< with visual geometry that encloses some volume
  std::vector<std::size_t> index;  ///< of the links, in `robot`
};

/// The robots of LINK_BOUNDS_DATA; where it is not set, the robot of `demo_urdf`, which is in the
/// folder launch/demo of its package. Writes to `notes` what is left out.
std::vector<MeasuredRobot> chooseRobots(const std::string& demo_urdf, std::ostream& notes);

}  // namespace link_bounds::bench

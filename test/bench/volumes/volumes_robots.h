// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robots whose links are measured.
#pragma once

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

/// See robots(). Prints what is left out.
std::vector<MeasuredRobot> chooseRobots();

}  // namespace link_bounds::bench

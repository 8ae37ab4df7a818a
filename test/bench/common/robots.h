// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robots that are measured.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "testing/robot_files.h"

namespace link_bounds::bench {

RobotFile demoRobot();

/// Those of LINK_BOUNDS_DATA; where it is not set, that of the demo, which a line says.
std::vector<RobotFile> robots();

struct MeasuredRobot {
  std::string name;  ///< of its URDF file
  Robot robot;
  std::vector<BoundedLink> links;
  std::vector<std::size_t> indices;  ///< of the links, in `robot`
  std::vector<Body> bodies;          ///< of the links, if the selection has triangles
};

/// Why a link cannot be measured; "" = it can.
inline std::string whyIncomplete(const BoundedLink& link) {
  return link.missing;
}

/// Loaded as the node loads it. Prints which links are left out.
MeasuredRobot measuredRobot(const RobotFile& file, const Selection& selection,
                            std::string (*why_left_out)(const BoundedLink&) = whyIncomplete);

}  // namespace link_bounds::bench

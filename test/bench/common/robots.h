// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robots that are measured.
#pragma once

#include <iostream>
#include <vector>

#include "testing/robot_files.h"

namespace link_bounds::bench {

inline RobotFile demoRobot() {
  return demoRobotFile(LINK_BOUNDS_PACKAGE "/launch/demo/demo.urdf");
}

/// Those of LINK_BOUNDS_DATA; where it is not set, that of the demo, which a line says.
inline std::vector<RobotFile> robots() {
  return robotsOrDemo(LINK_BOUNDS_PACKAGE "/launch/demo/demo.urdf", std::cout);
}

}  // namespace link_bounds::bench

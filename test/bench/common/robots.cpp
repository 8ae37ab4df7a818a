// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// LINK_BOUNDS_PACKAGE is the folder of this package.
#include "bench/common/robots.h"

#include <iostream>

namespace link_bounds::bench {
namespace {

constexpr char kDemo[] = LINK_BOUNDS_PACKAGE "/launch/demo/demo.urdf";

}  // namespace

RobotFile demoRobot() {
  return demoRobotFile(kDemo);
}

std::vector<RobotFile> robots() {
  return robotsOrDemo(kDemo, std::cout);
}

MeasuredRobot measuredRobot(const RobotFile& file, const Selection& selection,
                            std::string (*why_left_out)(const BoundedLink&)) {
  auto [robot, bounded] = loadRobot(
      textOf(file.urdf), {file.package_path, file.urdf.parent_path().string()}, selection);
  MeasuredRobot result{file.name(), std::move(robot), {}, {}, {}};
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const std::string reason = why_left_out(bounded.links[i]);
    if (!reason.empty()) {
      std::cout << "left out: link " << bounded.links[i].name << " of " << result.name << ": "
                << reason << "\n";
      continue;
    }
    result.links.push_back(bounded.links[i]);
    result.indices.push_back(bounded.indices[i]);
    if (selection.triangles) result.bodies.push_back(bounded.bodies[i]);
  }
  return result;
}

}  // namespace link_bounds::bench

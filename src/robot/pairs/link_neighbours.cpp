// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints stand from the root outward: a link whose joint stands later is never above the other one.
#include "robot/pairs/link_neighbours.h"

#include <string>

namespace link_bounds {

LinkNeighbours::LinkNeighbours(const Robot& robot, const BoundedRobot& bounded)
    : robot_(robot),
      links_(bounded.indices),
      rigid_(rigidBodies(robot)),
      joints_above_(robot.links.size(), 0),
      has_geometry_(robot.links.size(), false) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    joints_above_[robot.joints[j].child] = j + 1;
  for (const std::size_t link : links_)
    has_geometry_[link] = true;
}

bool LinkNeighbours::areRigid(std::size_t first, std::size_t second) const {
  return rigid_.of_links[links_[first]] == rigid_.of_links[links_[second]];
}

bool LinkNeighbours::areAdjacent(std::size_t first, std::size_t second) const {
  const auto isBetween = [&](std::size_t link) {
    return has_geometry_[link] && link != links_[first] && link != links_[second];
  };
  std::size_t a = links_[first];
  std::size_t b = links_[second];
  std::string counted;  // the floating or planar joint of which this one is a part
  for (int movable = 0; a != b;) {
    std::size_t& lower = joints_above_[a] > joints_above_[b] ? a : b;
    if (isBetween(lower)) return false;
    const Joint& joint = robot_.joints[joints_above_[lower] - 1];
    lower = joint.parent;
    if (joint.motion == Motion::kNone) continue;
    if (joint.part_of.empty() || joint.part_of != counted) ++movable;
    if (movable > 1) return false;
    counted = joint.part_of;
  }
  return !isBetween(a);
}

}  // namespace link_bounds

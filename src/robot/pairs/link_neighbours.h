// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links are joined so closely that MoveIt never checks them for collisions.
#pragma once

#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/overlap_filter.h"

namespace link_bounds {

/// Refers to the robot. Links by their index in BoundedRobot::links.
class LinkNeighbours {
 public:
  LinkNeighbours(const Robot& robot, const BoundedRobot& bounded);

  /// Fixed joints connect the two, over any number of links.
  bool areRigid(std::size_t first, std::size_t second) const;

  /// A joint is between the two: links without geometry are looked through, and so are fixed joints
  /// at them. At most one of the joints can move, and no link with geometry stands between.
  bool areAdjacent(std::size_t first, std::size_t second) const;

 private:
  const Robot& robot_;
  std::vector<std::size_t> links_;  ///< in the robot
  RigidBodies rigid_;
  std::vector<std::size_t> joints_above_;  ///< of each link of the robot, plus one; 0: the root
  std::vector<bool> has_geometry_;         ///< of each link of the robot
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The joints that move a link, from the root of the robot to the link.
#pragma once

#include <vector>

#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// A number that the joints of a chain depend on: the value of a joint that leads them.
struct ChainVariable {
  std::size_t joint;  ///< index in the robot; not always a joint of the chain
  Limits range;       ///< [rad or m]
  bool is_shared;     ///< several joints of the chain depend on it
};

/// A joint that moves: its value is factor * variable + offset.
struct ChainJoint {
  /// From the frame of the joint before it, moved, to its own, not moved.
  Eigen::Isometry3d before;
  const Joint* source;   ///< in the robot
  std::size_t variable;  ///< index in Chain::variables
  double factor;
  double offset;  ///< [rad or m]
};

/// Fixed joints, and those whose range is one value, are parts of the poses between the others.
struct Chain {
  std::vector<ChainVariable> variables;
  std::vector<ChainJoint> joints;
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();  ///< from the last joint to the link
  std::size_t length = 0;  ///< of the way from the root: the number of joints of any kind

  /// The pose of the link in the root's frame; one value per variable.
  Eigen::Isometry3d pose(const std::vector<double>& values) const;
};

/// `ranges` are those of all joints of the robot, which must live as long as the chain.
Chain chainTo(const Robot& robot, const std::vector<JointRange>& ranges, std::size_t link);

}  // namespace link_bounds

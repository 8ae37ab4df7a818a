// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Robots whose distances are measured: their bodies, pairs of links that may collide, and motions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds::bench {

struct DistanceLink {
  Body body;
  /// For FCL: the triangles of our trees, in their order, in the frame of the link; vertices may be
  /// there several times. Empty if a shape is a solid.
  TriangleMesh mesh;
};

/// The pose of each link.
using LinkPoses = std::vector<Eigen::Affine3d>;

struct DistanceRobot {
  std::string name;  ///< of its URDF file, and "visual" or "collision"
  std::vector<DistanceLink> links;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< of links that no joint connects
  std::map<std::string, std::vector<LinkPoses>> motions;   ///< "random" and "coherent"
  std::size_t poses_per_peer = 0;  ///< of a motion, after the first: others take longer
};

/// Each motion has twelve times `steps` poses. See robots(). Prints what is left out.
std::vector<DistanceRobot> distanceRobots(std::size_t steps);

}  // namespace link_bounds::bench

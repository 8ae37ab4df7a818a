// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points of a cloud belong to the robot, and to which link.
#pragma once

#include <memory>
#include <vector>

#include "geometry/cloud/body_grid.h"
#include "world/cloud/scan_poses.h"

namespace link_bounds {

struct RobotPoint {
  std::size_t point;  ///< index in the cloud
  std::size_t link;   ///< any one if there are several; kTooNear: none
};

/// Stands for the link of a point that is nearer to the sensor than min_distance.
constexpr std::size_t kTooNear = static_cast<std::size_t>(-1);

struct PointQuery {
  const CloudPoints& points;
  const std::vector<std::shared_ptr<const BodyGrid>>&
      grids;                ///< by link; their max_slack is kMaxMotionError
  const ScanPoses& poses;   ///< for these links, at the times of these points
  double min_distance = 0;  ///< points nearer to the sensor belong to the robot, too [m]
  /// Whether points that a link hides from the sensor's origin count, see BodySurface::crosses().
  /// The pose of the link is interpolated. A link that contains the origin hides nothing, and the
  /// part of the line of sight within min_distance is ignored.
  bool with_shadow = false;
};

/// All points that are in a link or within the padding of one, at their own times, in the order of
/// the cloud. No result is farther from all links than the padding plus twice LinkMotion::error,
/// which is less than 1 mm together, except by min_distance or shadow. Points that are not finite
/// are never among them. The work is divided among `threads`.
std::vector<RobotPoint> robotPoints(const PointQuery& query, std::size_t threads = 1);

}  // namespace link_bounds

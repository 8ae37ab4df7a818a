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
  std::size_t link;   ///< of several, any one; kTooNear: none
};

/// The link of a point that is nearer to the sensor than it can measure.
constexpr std::size_t kTooNear = static_cast<std::size_t>(-1);

struct PointQuery {
  const CloudPoints& points;
  const std::vector<std::shared_ptr<const BodyGrid>>&
      grids;                ///< by link, max_slack kMaxMotionError
  const ScanPoses& poses;   ///< of these links, of these points
  double min_distance = 0;  ///< nearer points belong to the robot, too [m]
  /// Whether points count that a link hides from the origin of the sensor's frame: see
  /// BodySurface::crosses(), in the interpolated pose of the link. A link that this origin belongs
  /// to hides nothing, and neither does what is nearer than min_distance.
  bool with_shadow = false;
};

/// In the order of the cloud: all points that are at most the padding from a link, or inside it, at
/// their own time. None that is farther than the padding and twice LinkMotion::error, which is less
/// than 1 mm, from all links. Points that are not finite are never among them. The work is divided
/// among `threads`.
std::vector<RobotPoint> robotPoints(const PointQuery& query, std::size_t threads = 1);

}  // namespace link_bounds

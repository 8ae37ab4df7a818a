// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The point of a cloud that is the nearest one to each link, of those that are not the robot's.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/cloud/robot_points.h"

namespace link_bounds {

/// Farther points are left out [m].
constexpr double kMaxPointRange = 1000;

/// Both at the time of the point, in the sensor's frame.
struct NearestPoint {
  std::size_t point;   ///< index in the cloud
  std::int64_t stamp;  ///< its time [ns]
  double lower;        ///< proven: no point that was left in the cloud is nearer to the link [m]
  double upper;        ///< between the next two
  Eigen::Vector3d on_link, on_cloud;
  bool is_of_mesh;  ///< triangles decided, not a solid or a convex hull
};

struct NearestQuery {
  const CloudPoints& points;
  const std::vector<RobotPoint>& removed;  ///< in order
  const std::vector<std::shared_ptr<const BodyGrid>>& grids;
  const std::vector<ScannedLink>& links;  ///< of these grids
  const TransformBuffer& tf;
  TransformBuffer::Frame sensor;
};

struct NearestPoints {
  std::vector<std::optional<NearestPoint>> links;  ///< nothing for a link without a finite box, and
                                                   ///< where no point is left
  std::string problem;                             ///< why there are none, in words
};

NearestPoints nearestPoints(const NearestQuery& query);

}  // namespace link_bounds

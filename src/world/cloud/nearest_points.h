// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The point of a cloud that is nearest to each link, without the points of the robot.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/cloud/robot_points.h"

namespace link_bounds {

/// Points farther from the sensor than this are ignored [m].
constexpr double kMaxPointRange = 1000;

/// A point and the nearest place on a link, both at the time of the point, in the sensor's frame.
struct NearestPoint {
  std::size_t point;   ///< index in the cloud
  std::int64_t stamp;  ///< its time [ns]
  double lower;        ///< proven: no remaining point of the cloud is nearer to the link [m]
  double upper;        ///< distance between the next two [m]
  Eigen::Vector3d on_link, on_cloud;
  bool is_of_mesh;  ///< on a triangle of a mesh, not on a solid or a convex hull
};

struct NearestQuery {
  const CloudPoints& points;
  const std::vector<RobotPoint>& removed;  ///< in the order of the cloud
  const std::vector<std::shared_ptr<const BodyGrid>>& grids;
  const std::vector<ScannedLink>& links;  ///< the links of these grids
  const TransformBuffer& tf;
  TransformBuffer::Frame sensor;
};

struct NearestPoints {
  std::vector<std::optional<NearestPoint>> links;  ///< nothing for a link without a finite box, and
                                                   ///< where no point is left
  std::string problem;                             ///< why there are no results, in words
};

NearestPoints nearestPoints(const NearestQuery& query);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Four corners, each coordinate rounded away from the robot.
#include "node/outputs/footprint.h"

#include <cmath>

#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {

std::optional<geometry_msgs::Polygon> footprintOf(const BoxState& robot) {
  if (!robot.box || robot.incomplete) return std::nullopt;
  const float low_x = floatDown(robot.box->min().x());
  const float low_y = floatDown(robot.box->min().y());
  const float high_x = floatUp(robot.box->max().x());
  const float high_y = floatUp(robot.box->max().y());
  geometry_msgs::Polygon polygon;
  for (const auto& [x, y] :
       {std::pair(low_x, low_y), {high_x, low_y}, {high_x, high_y}, {low_x, high_y}}) {
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    geometry_msgs::Point32 point;
    point.x = x;
    point.y = y;
    polygon.points.push_back(point);
  }
  return polygon;
}

}  // namespace link_bounds

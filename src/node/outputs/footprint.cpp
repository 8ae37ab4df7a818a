// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rounds each coordinate outward.
#include "node/outputs/footprint.h"

#include <cmath>

#include "link_bounds/geometry/box/rounding.h"
#include "node/parameters/parameters.h"

namespace link_bounds {

namespace {

/// Group robot is the first one in both lists.
bool isRobotComplete(const AxisAlignedBoxArray& groups) {
  const bool has_box = !groups.boxes.empty() && groups.boxes.front().name == kRobotGroup;
  return has_box && (groups.incomplete.empty() || groups.incomplete.front() != kRobotGroup);
}

}  // namespace

std::optional<geometry_msgs::Polygon> footprintOf(const AxisAlignedBoxArray& groups) {
  if (!isRobotComplete(groups)) return std::nullopt;
  const AxisAlignedBox& box = groups.boxes.front();
  const float min_x = floatDown(box.min.x);
  const float min_y = floatDown(box.min.y);
  const float max_x = floatUp(box.max.x);
  const float max_y = floatUp(box.max.y);
  geometry_msgs::Polygon polygon;
  for (const auto& [x, y] :
       {std::pair(min_x, min_y), {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}) {
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    geometry_msgs::Point32 point;
    point.x = x;
    point.y = y;
    polygon.points.push_back(point);
  }
  return polygon;
}

}  // namespace link_bounds

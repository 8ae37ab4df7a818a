// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rounds each coordinate outward to float32.
#include "node/outputs/messages/footprint.h"

#include <cmath>

#include "link_bounds/geometry/box/rounding.h"
#include "world/model/parameters.h"

namespace link_bounds {
namespace {

/// nullopt if a coordinate is too large for float32.
std::optional<geometry_msgs::Polygon> rectangleOf(const AxisAlignedBox& box) {
  const float min_x = floatDown(box.min.x);
  const float min_y = floatDown(box.min.y);
  const float max_x = floatUp(box.max.x);
  const float max_y = floatUp(box.max.y);
  geometry_msgs::Polygon polygon;
  for (const auto& [x, y] :
       {std::pair(min_x, min_y), {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}) {
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    geometry_msgs::Point32 point;
    point.x = x + 0.0F;  // turns -0 into 0
    point.y = y + 0.0F;
    polygon.points.push_back(point);
  }
  return polygon;
}

/// Why the box of group robot cannot be used; "" if it can. Group robot is always the first entry
/// of both lists.
std::string whyNoRobot(const AxisAlignedBoxArray& groups) {
  if (groups.boxes.empty() || groups.boxes.front().name != kRobotGroup) return "no link has a box";
  if (!groups.incomplete.empty() && groups.incomplete.front() == kRobotGroup)
    return "group robot is incomplete";
  return "";
}

}  // namespace

std::optional<geometry_msgs::Polygon> footprintOf(const AxisAlignedBoxArray& groups) {
  if (!whyNoRobot(groups).empty()) return std::nullopt;
  return rectangleOf(groups.boxes.front());
}

std::string whyNoFootprint(const AxisAlignedBoxArray& groups) {
  const std::string reason = whyNoRobot(groups);
  if (!reason.empty()) return reason;
  return rectangleOf(groups.boxes.front()) ? "" : "box robot is too large for float32";
}

}  // namespace link_bounds

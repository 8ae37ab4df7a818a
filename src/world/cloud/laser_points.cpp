// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/cloud/laser_points.h"

#include <limits>

namespace link_bounds {

LaserPoints::LaserPoints(const sensor_msgs::LaserScan& scan) {
  points_.height = 1;
  points_.stamp = static_cast<std::int64_t>(scan.header.stamp.toNSec());
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment) ||
      !std::isfinite(scan.time_increment)) {
    problem_ = "angle_min, angle_increment or time_increment is not finite; correct it";
    return;
  }
  if (!(scan.range_min <= scan.range_max) || !(scan.range_max > 0)) {
    problem_ = "range_min or range_max is no number, or no range is between them; correct them";
    return;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  memory_.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto number = static_cast<double>(i);
    const double angle = scan.angle_min + number * scan.angle_increment;
    const double range = scan.ranges[i];
    const bool is_measured = range >= scan.range_min && range <= scan.range_max;
    const double length = is_measured ? range : nan;
    memory_.push_back({length * std::cos(angle), length * std::sin(angle), is_measured ? 0 : nan,
                       number * scan.time_increment});
  }
  points_.data = reinterpret_cast<const std::uint8_t*>(memory_.data());
  points_.width = memory_.size();
  points_.point_step = sizeof(Point);
  points_.row_step = memory_.size() * sizeof(Point);
  points_.x = offsetof(Point, x);
  points_.y = offsetof(Point, y);
  points_.z = offsetof(Point, z);
  points_.is_double = true;
  points_.time = NumberField{offsetof(Point, seconds), NumberType::kFloat64};
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/cloud/without_points.h"

#include <cstring>
#include <limits>

namespace link_bounds {
namespace {

template <class Number>
void writeNan(std::uint8_t* point, const CloudPoints& points) {
  constexpr Number nan = std::numeric_limits<Number>::quiet_NaN();
  for (const std::size_t offset : {points.x, points.y, points.z})
    std::memcpy(point + offset, &nan, sizeof nan);
}

void makeOneRow(std::size_t count, sensor_msgs::PointCloud2& cloud) {
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(count);
  cloud.row_step = static_cast<std::uint32_t>(count) * cloud.point_step;
  cloud.data.resize(count * cloud.point_step);
}

/// Moves the remaining points to the front.
void leaveOut(const std::vector<RobotPoint>& removed, const CloudPoints& points,
              sensor_msgs::PointCloud2& cloud) {
  std::size_t kept = 0;
  auto next = removed.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (next != removed.end() && next->point == i) {
      ++next;
      continue;
    }
    std::memmove(cloud.data.data() + kept * cloud.point_step, points.point(i), cloud.point_step);
    ++kept;
  }
  makeOneRow(kept, cloud);
}

}  // namespace

void removePoints(const std::vector<RobotPoint>& removed, bool keep_organized,
                  sensor_msgs::PointCloud2& cloud) {
  const CloudPoints points = layoutOf(cloud).points;
  if (!keep_organized) {
    leaveOut(removed, points, cloud);
    return;
  }
  if (!removed.empty()) cloud.is_dense = false;
  for (const RobotPoint& point : removed) {
    std::uint8_t* bytes = cloud.data.data() + (points.point(point.point) - points.data);
    if (points.is_double) {
      writeNan<double>(bytes, points);
    } else {
      writeNan<float>(bytes, points);
    }
  }
}

void removePoints(const std::vector<RobotPoint>& removed, sensor_msgs::LaserScan& scan) {
  for (const RobotPoint& point : removed)
    scan.ranges[point.point] = std::numeric_limits<float>::quiet_NaN();
}

sensor_msgs::PointCloud2 onlyPoints(const std::vector<RobotPoint>& kept,
                                    const sensor_msgs::PointCloud2& cloud) {
  const CloudPoints points = layoutOf(cloud).points;
  sensor_msgs::PointCloud2 result;
  result.header = cloud.header;
  result.fields = cloud.fields;
  result.is_bigendian = cloud.is_bigendian;
  result.point_step = cloud.point_step;
  result.is_dense = cloud.is_dense;
  result.data.reserve(kept.size() * cloud.point_step);
  for (const RobotPoint& point : kept) {
    const std::uint8_t* bytes = points.point(point.point);
    result.data.insert(result.data.end(), bytes, bytes + cloud.point_step);
  }
  makeOneRow(kept.size(), result);
  return result;
}

}  // namespace link_bounds

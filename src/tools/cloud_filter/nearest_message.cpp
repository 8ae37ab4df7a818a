// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/nearest_message.h"

#include <algorithm>
#include <limits>

#include "link_bounds/ros/messages.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

constexpr char kCloudName[] = "cloud";
/// Max of ros::Time [ns]. If no transform moves, the time of a point may be garbage beyond it.
constexpr std::int64_t kLatest = 4'294'967'295'999'999'999;

Distance toDistance(const std::string& name, const NearestPoint& nearest) {
  Distance result;
  result.first = name;
  result.second = kCloudName;
  result.stamp = timeFrom(std::clamp(nearest.stamp, std::int64_t{0}, kLatest));
  result.distance = nearest.lower;
  result.distance_max = nearest.upper;
  result.on_first = toPoint(nearest.on_link);
  result.on_second = toPoint(nearest.on_cloud);
  const Eigen::Vector3d way = nearest.on_cloud - nearest.on_link;
  if (nearest.lower > 0 && way.norm() > 0) result.normal = toVector3(way.normalized());
  result.level = nearest.is_of_mesh ? Distance::MESH : Distance::HULL;
  return result;
}

}  // namespace

DistanceArray nearestMessage(const std_msgs::Header& header, const std::vector<std::string>& names,
                             const std::vector<std::optional<NearestPoint>>& nearest,
                             const std::vector<std::string>& incomplete) {
  DistanceArray result;
  result.header = header;
  result.incomplete = incomplete;
  // Every body is compared, however far the cloud is.
  result.limit = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!nearest[i]) continue;
    result.distances.push_back(toDistance(names[i], *nearest[i]));
    const Distance& distance = result.distances.back();
    result.accuracy = std::max(result.accuracy, distance.distance_max - distance.distance);
  }
  return result;
}

}  // namespace link_bounds

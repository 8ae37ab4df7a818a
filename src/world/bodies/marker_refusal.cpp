// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The checks are in the order in which a user fixes a marker.
#include "world/bodies/marker_refusal.h"

#include <algorithm>
#include <cmath>

#include "world/bodies/marker_shape.h"
#include "world/bodies/number_limit.h"
#include "world/tf/tf_message.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

bool isFinite(const geometry_msgs::Quaternion& q) {
  return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w);
}

/// Four points at a time, so that the twelve numbers fill vector registers. A max may lose a NaN; a
/// sum does not. For why the loop counts down, see direction_query.h.
bool areBelowLimit(const std::vector<geometry_msgs::Point>& points) {
  using Twelve = Eigen::Array<double, 12, 1>;
  Twelve max = Twelve::Zero();
  Twelve nan_sum = Twelve::Zero();
  std::size_t i = points.size();
  for (; i >= 4; i -= 4) {
    const Eigen::Map<const Twelve> four(&points[i - 4].x);
    max = max.max(four.abs());
    nan_sum += 0 * four;
  }
  return max.maxCoeff() <= kMaxNumber && nan_sum.sum() == 0 &&
         std::all_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i),
                     [](const geometry_msgs::Point& point) { return isBelowLimit(point); });
}

bool isUnknown(const Marker& marker) {
  return marker.type < Marker::ARROW || marker.type > Marker::TRIANGLE_LIST;
}

bool hasPoints(const Marker& marker) {
  return marker.type == Marker::ARROW || isList(marker);
}

/// The number of points that rviz needs, in words; null if the marker has them.
const char* wantedCount(const Marker& marker) {
  const std::size_t count = marker.points.size();
  if (count == 0 && isList(marker))
    return "a list needs at least 1; to remove the marker, send DELETE";
  switch (marker.type) {
    case Marker::ARROW:
      return count == 0 || count == 2 ? nullptr : "an ARROW needs none or 2";
    case Marker::LINE_STRIP:
      return count >= 2 ? nullptr : "a LINE_STRIP needs at least 2";
    case Marker::LINE_LIST:
      return count % 2 == 0 ? nullptr : "a LINE_LIST needs pairs";
    case Marker::TRIANGLE_LIST:
      return count % 3 == 0 ? nullptr : "a TRIANGLE_LIST needs threes";
    default:
      return nullptr;
  }
}

bool hasNegative(const geometry_msgs::Vector3& v) {
  return v.x < 0 || v.y < 0 || v.z < 0;
}

std::string limits() {
  return "has a number that is not finite or above 1e29; correct what computes it";
}

}  // namespace

std::string whyMarkerRefused(const Marker& marker) {
  if (marker.action != Marker::ADD) {
    return "action " + std::to_string(marker.action) +
           " is not one that visualization_msgs/Marker names; set action";
  }
  if (!hasShape(marker)) return "";
  if (isUnknown(marker)) {
    return "type " + std::to_string(marker.type) +
           " is not one that visualization_msgs/Marker names; set type";
  }
  if (marker.header.frame_id.empty() || marker.header.frame_id == "/")
    return "header.frame_id is empty; name the frame in which the pose is given";
  if (!marker.frame_locked && !isTime(marker.header.stamp))
    return "header.stamp is no time that tf can handle; correct it, or stamp 0 to follow the frame";
  if (!isBelowLimit(marker.pose.position) || !isFinite(marker.pose.orientation))
    return "pose " + limits();
  if (!isBelowLimit(marker.scale)) return "scale " + limits();
  if (hasNegative(marker.scale)) return "scale is negative; give lengths, turn by the pose";
  if (const char* wanted = wantedCount(marker))
    return "points has " + std::to_string(marker.points.size()) + " elements; " + wanted;
  if (hasPoints(marker) && !areBelowLimit(marker.points)) return "points " + limits();
  if (marker.type == Marker::MESH_RESOURCE && marker.mesh_resource.empty())
    return "mesh_resource is empty; name a mesh file, such as package://my_package/part.stl";
  return "";
}

}  // namespace link_bounds

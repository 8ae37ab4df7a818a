// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is asked of a marker before it is bounded.
#include <algorithm>
#include <cmath>

#include "node/objects/marker_shape.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

/// Below the 1e30 that a pose may contain, with room for what turning it adds by rounding.
constexpr double kLargest = 1e29;

/// Not for what is not a number.
bool isBelowLimit(double value) {
  return std::abs(value) <= kLargest;
}

template <class Vector>
bool isBelowLimit(const Vector& v) {
  return isBelowLimit(v.x) && isBelowLimit(v.y) && isBelowLimit(v.z);
}

bool isFinite(const geometry_msgs::Quaternion& q) {
  return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w);
}

/// Four points at a time, so that the twelve numbers fill whole vectors. What is not a number would
/// get lost in a maximum, but not in a sum. Downwards, for the reason that point_scan.h tells.
bool areBelowLimit(const std::vector<geometry_msgs::Point>& points) {
  using Twelve = Eigen::Array<double, 12, 1>;
  Twelve largest = Twelve::Zero();
  Twelve nothing = Twelve::Zero();
  std::size_t i = points.size();
  for (; i >= 4; i -= 4) {
    const Eigen::Map<const Twelve> four(&points[i - 4].x);
    largest = largest.max(four.abs());
    nothing += 0 * four;
  }
  return largest.maxCoeff() <= kLargest && nothing.sum() == 0 &&
         std::all_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i),
                     [](const geometry_msgs::Point& point) { return isBelowLimit(point); });
}

bool isUnknown(const Marker& marker) {
  return marker.type < Marker::ARROW || marker.type > Marker::TRIANGLE_LIST;
}

bool hasPoints(const Marker& marker) {
  return marker.type == Marker::ARROW || isList(marker);
}

/// What rviz demands of the number of points; null if that is met.
const char* wantedCount(const Marker& marker) {
  const std::size_t count = marker.points.size();
  switch (marker.type) {
    case Marker::ARROW:
      return count == 0 || count == 2 ? nullptr : "an ARROW needs none or 2";
    case Marker::LINE_STRIP:
      return count >= 2 ? nullptr : "a LINE_STRIP needs at least 2";
    case Marker::LINE_LIST:
      return count > 0 && count % 2 == 0 ? nullptr : "a LINE_LIST needs pairs";
    case Marker::TRIANGLE_LIST:
      return count > 0 && count % 3 == 0 ? nullptr : "a TRIANGLE_LIST needs threes";
    default:
      return count > 0 || !hasPoints(marker) ? nullptr
                                             : "a list needs at least 1; to remove the "
                                               "marker, send DELETE";
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

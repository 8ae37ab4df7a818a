// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loose box is that of the eight corners.
#include "bench/common/usual_tf2.h"

#include <tf2/exceptions.h>

#include <utility>

#include "link_bounds/ros/messages.h"

namespace link_bounds::bench {
namespace {

Eigen::Isometry3d toIsometry(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  const auto& t = transform.translation;
  return Eigen::Translation3d(t.x, t.y, t.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

visualization_msgs::Marker markerOf(const Aabb& box, const std::string& frame,
                                    const std_msgs::Header& header) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = frame;
  marker.type = visualization_msgs::Marker::CUBE;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.position = toPoint(box.center());
  marker.pose.orientation.w = 1;
  marker.scale = toVector3(box.sizes());
  marker.color.b = 1;
  marker.color.a = 0.5;
  return marker;
}

/// The resting box, turned with the link and boxed again, and the transform's header.
std::pair<Aabb, std_msgs::Header> looseBox(const tf2::BufferCore& buffer,
                                           const std::string& fixed_frame, const UsualLink& link) {
  const auto transform = buffer.lookupTransform(fixed_frame, link.frame, ros::Time(0));
  const Eigen::Isometry3d fixed_from_link = toIsometry(transform.transform);
  Aabb box;
  for (const Eigen::Vector3d& corner : corners(link.resting))
    box.extend(fixed_from_link * corner);
  return {box, transform.header};
}

}  // namespace

visualization_msgs::MarkerArray usualMarkers(const tf2::BufferCore& buffer,
                                             const std::string& fixed_frame,
                                             const std::vector<UsualLink>& links) {
  visualization_msgs::MarkerArray markers;
  for (const UsualLink& link : links) {
    try {
      const auto [box, header] = looseBox(buffer, fixed_frame, link);
      markers.markers.push_back(markerOf(box, link.frame, header));
    } catch (const tf2::TransformException&) {
      continue;
    }
  }
  return markers;
}

AxisAlignedBoxArray usualBoxes(const tf2::BufferCore& buffer, const std::string& fixed_frame,
                               const std::vector<UsualLink>& links) {
  AxisAlignedBoxArray array;
  for (const UsualLink& link : links) {
    try {
      const auto [loose, header] = looseBox(buffer, fixed_frame, link);
      array.header = header;
      AxisAlignedBox box;
      box.name = link.frame;
      box.stamp = header.stamp;
      box.min = toPoint(loose.min());
      box.max = toPoint(loose.max());
      array.boxes.push_back(box);
    } catch (const tf2::TransformException&) {
      array.incomplete.push_back(link.frame);
    }
  }
  return array;
}

}  // namespace link_bounds::bench

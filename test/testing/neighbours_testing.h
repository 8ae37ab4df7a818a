// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of other nodes beside markers, by name.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>

#include <limits>
#include <set>

#include "link_bounds/ros/messages.h"
#include "testing/live_objects_testing.h"
#include "testing/marker_testing.h"
#include "world/bodies/neighbour_sets.h"
#include "world/bodies/object_source.h"

namespace link_bounds {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Of 2 x 4 x 6 m.
inline AxisAlignedBox boxAround(const std::string& name, const Eigen::Vector3d& center,
                                double stamp) {
  AxisAlignedBox box;
  box.name = name;
  box.stamp = ros::Time(stamp);
  box.min = toPoint(center - Eigen::Vector3d(1, 2, 3));
  box.max = toPoint(center + Eigen::Vector3d(1, 2, 3));
  return box;
}

inline AxisAlignedBoxArray arrayOf(const std::string& frame,
                                   const std::vector<AxisAlignedBox>& boxes,
                                   const std::vector<std::string>& incomplete = {}) {
  AxisAlignedBoxArray array;
  array.header.frame_id = frame;
  array.boxes = boxes;
  array.incomplete = incomplete;
  return array;
}

class NeighboursTest : public LiveObjectsTest {
 protected:
  bool take(const AxisAlignedBoxArray& array, const std::string& sender = "/right/bounds") {
    return neighbours_.take(array, {sender}, now_);
  }

  bool takeMarker(int action, const ObjectKey& key = kKey,
                  const std::string& publisher = "/camera") {
    visualization_msgs::Marker marker =
        markerOf(visualization_msgs::Marker::CUBE, Eigen::Vector3d::Ones());
    marker.header.frame_id = "map";
    marker.ns = key.ns;
    marker.id = key.id;
    marker.action = action;
    return source_.take(std::move(marker), publisher, now_);
  }

  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& [key, object] : objects_.objects())
      result.insert(object.content->bounded.name);
    return result;
  }

  /// The first one of the name.
  const LiveObject* find(const std::string& name) const {
    const auto [begin, end] = objects_.named(*parseObjectName(name));
    return begin == end ? nullptr : &begin->second;
  }

  const LiveObject& arm() const { return *find("/right/bounds/arm"); }

  ObjectSource source_{objects_, [](const MeshRequest&) {}};
  NeighbourSets neighbours_{objects_};
};

}  // namespace link_bounds

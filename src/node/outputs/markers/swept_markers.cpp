// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Always the same two marker ids, so that no old marker stays in rviz.
#include "node/outputs/markers/swept_markers.h"

#include "node/outputs/markers/drawable.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

/// ObjectSource ignores markers whose namespaces begin with "link_bounds/".
struct Look {
  const char* ns;
  double red, green, blue;
};

constexpr Look kSweptLook{"link_bounds/swept", 1, 0.5, 0};
constexpr Look kStoppingLook{"link_bounds/stopping", 1, 0, 0.6};

constexpr double kSweptLineWidth = 0.002;  ///< [m]
/// Translucent, so that the robot and its boxes stay visible inside.
constexpr double kFaceAlpha = 0.15;
constexpr double kEdgeAlpha = 0.6;

Marker marker(const std_msgs::Header& header, const Look& look, int id, int type, double alpha) {
  Marker result = newMarker(header, look.ns, id, type);
  result.color = toColor({look.red, look.green, look.blue, alpha});
  return result;
}

void addFaces(const std::array<Eigen::Vector3d, 8>& corner, Marker& triangles) {
  for (const auto& quad : kQuads) {
    for (const int k : {0, 1, 2, 0, 2, 3}) {
      const int number = quad[static_cast<std::size_t>(k)];
      triangles.points.push_back(toPoint(corner[static_cast<std::size_t>(number)]));
    }
  }
}

visualization_msgs::MarkerArray motionMarkers(const AxisAlignedBoxArray& boxes, const Look& look) {
  Marker faces = marker(boxes.header, look, 0, Marker::TRIANGLE_LIST, kFaceAlpha);
  faces.scale.x = faces.scale.y = faces.scale.z = 1;
  Marker lines = marker(boxes.header, look, 1, Marker::LINE_LIST, kEdgeAlpha);
  lines.scale.x = kSweptLineWidth;
  for (const AxisAlignedBox& message : boxes.boxes) {
    const Aabb box = toAabb(message);
    if (!isDrawable(box)) continue;
    const std::array<Eigen::Vector3d, 8> corner = corners(box);
    addFaces(corner, faces);
    appendEdges(corner, lines);
  }
  faces.action = lines.action = faces.points.empty() ? Marker::DELETE : Marker::ADD;
  visualization_msgs::MarkerArray array;
  array.markers = {std::move(faces), std::move(lines)};
  return array;
}

}  // namespace

visualization_msgs::MarkerArray sweptMarkers(const AxisAlignedBoxArray& boxes) {
  return motionMarkers(boxes, kSweptLook);
}

visualization_msgs::MarkerArray stoppingMarkers(const AxisAlignedBoxArray& boxes) {
  return motionMarkers(boxes, kStoppingLook);
}

}  // namespace link_bounds

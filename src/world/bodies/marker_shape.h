// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The shapes that bound a visualization marker as rviz draws it.
//
// What each type makes of the marker's fields, all in the frame of its pose [m]:
//   CUBE, SPHERE, CYLINDER   a solid of extent scale around the origin; the cylinder's axis is z
//   CUBE_LIST, SPHERE_LIST   that solid around each point; scale does not scale the points
//   LINE_STRIP, LINE_LIST    ribbons of width scale.x that turn to the camera: a ball around each
//                            point contains them from every side; scale.y and scale.z are unused
//   POINTS                   squares that turn to the camera, the longer diagonal is
//                            hypot(scale.x, scale.y); the positions follow the pose
//   TRIANGLE_LIST            points times scale
//   MESH_RESOURCE            vertices of the file times scale
//   ARROW, no points         along x from the origin, scale.x long: a shaft as wide as scale.y and
//                            as high as scale.z, then, for the last 23 % of the length, a cone
//                            twice as wide and high
//   ARROW, two points        from the first to the second: a shaft of diameter scale.x, a cone of
//                            diameter scale.y and length scale.z, but no longer than the arrow, and
//                            23 % of it for scale.z = 0
//   TEXT_VIEW_FACING         its size depends on a font; ignored
// A zero in scale makes the shape flat, in rviz and here. For POINTS and SPHERE_LIST, rviz 1.14
// uses only scale.x if the graphics card has geometry shaders, else scale.x and scale.y: with
// uneven scale its picture depends on the machine.
#pragma once

#include <visualization_msgs/Marker.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// How a marker draws its shapes. A box needs only the shapes; a distance also needs this.
enum class DrawingKind {
  kSolids,     ///< each shape as it is
  kPoints,     ///< the solid at each point
  kSegments,   ///< from each even point to the next, swept by the solid
  kStrip,      ///< from each point to the next, swept by the solid
  kTriangles,  ///< three points each
  kMesh,       ///< the triangles of `mesh_uri`
  kArrow,      ///< a shaft, then the base and the tip of a cone
};

struct Drawing {
  DrawingKind kind = DrawingKind::kSolids;
  double cone_height = 0;  ///< of an arrow, along z of the base [m]
  bool operator==(const Drawing& other) const {
    return kind == other.kind && cone_height == other.cone_height;
  }
};

/// A marker as shapes.
struct MarkerShape {
  /// Each link_from_shape is the pose of a shape in the frame of the marker's header. The one shape
  /// of a MESH_RESOURCE lacks its points: they are those of `mesh_uri`.
  std::vector<Shape> shapes;
  std::string mesh_uri;  ///< of a MESH_RESOURCE, else ""
  Drawing drawing;
};

/// False for text, which has no box.
bool hasShape(const visualization_msgs::Marker& marker);

/// True for types that draw something at each of their points. False for arrows, whose points are
/// ends.
bool isList(const visualization_msgs::Marker& marker);

/// The pose of the marker in its header frame. A zero quaternion is the identity, others are
/// normalised. The marker must not be refused.
Eigen::Isometry3d markerPose(const visualization_msgs::Marker& marker);

/// The marker must have a shape and not be refused. Moves its points out, because copying them
/// would take longer than all other steps. Keeps nothing else of the message, such as colours.
MarkerShape markerShape(visualization_msgs::Marker&& marker);

}  // namespace link_bounds

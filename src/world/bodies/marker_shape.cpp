// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One short function per kind of marker.
#include "world/bodies/marker_shape.h"

#include <algorithm>

#include "link_bounds/geometry/box/length.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

/// Fractions of an arrow's length in rviz (arrow_marker.cpp), unless scale.z gives the head's
/// length.
constexpr double kHeadPart = 0.23;
constexpr double kShaftPart = 0.77;

Eigen::Vector3d toVector(const geometry_msgs::Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Vector3d toVector(const geometry_msgs::Point& p) {
  return {p.x, p.y, p.z};
}

/// Takes over the memory of the points.
std::shared_ptr<const PointSet> pointSet(std::vector<geometry_msgs::Point> points) {
  static_assert(sizeof(geometry_msgs::Point) == 3 * sizeof(double));
  const auto owner = std::make_shared<const std::vector<geometry_msgs::Point>>(std::move(points));
  return std::make_shared<const PointSet>(std::shared_ptr<const double>(owner, &owner->front().x),
                                          owner->size());
}

/// A cylinder around `center`. `size` is its diameters along the first two `axes` and its length
/// along the third. A disc if the length is 0.
Shape cylinder(const Eigen::Isometry3d& pose, const Eigen::Vector3d& center,
               const Eigen::Matrix3d& axes, const Eigen::Vector3d& size) {
  Shape shape{nullptr, Solid::kCylinder, size, pose};
  shape.link_from_shape.translate(center).rotate(axes);
  return shape;
}

Shape point(const Eigen::Isometry3d& pose, const Eigen::Vector3d& position) {
  Shape shape{nullptr, Solid::kNone, Eigen::Vector3d::Zero(), pose};
  shape.link_from_shape.translate(position);
  return shape;
}

/// An arrow in the frame of the marker.
struct Arrow {
  Eigen::Vector3d tail;
  Eigen::Matrix3d axes;   ///< the third points to the tip
  Eigen::Vector2d shaft;  ///< diameters along the first two axes
  Eigen::Vector2d head;   ///< diameters of the cone along these axes
  double shaft_length;
  double head_length;
};

Arrow arrowByPose(const Marker& marker) {
  const Eigen::Vector3d scale = toVector(marker.scale);
  Eigen::Matrix3d axes;
  axes << Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX();
  return {{0, 0, 0},
          axes,
          scale.tail(2),
          2 * scale.tail(2),
          kShaftPart * scale.x(),
          kHeadPart * scale.x()};
}

Arrow arrowByPoints(const Marker& marker) {
  const Eigen::Vector3d tail = toVector(marker.points[0]);
  const Eigen::Vector3d shaft = toVector(marker.points[1]) - tail;
  const double total = length(shaft.x(), shaft.y(), shaft.z());
  const double head =
      marker.scale.z == 0 ? kHeadPart * total : std::min<double>(marker.scale.z, total);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // rviz draws an arrow of length 0 along z
  if (total > 0) {
    axes.col(2) = shaft.stableNormalized();
    axes.col(0) = axes.col(2).unitOrthogonal();
    axes.col(1) = axes.col(2).cross(axes.col(0));
  }
  return {tail,
          axes,
          Eigen::Vector2d::Constant(marker.scale.x),
          Eigen::Vector2d::Constant(marker.scale.y),
          total - head,
          head};
}

Arrow arrowOf(const Marker& marker) {
  return marker.points.empty() ? arrowByPose(marker) : arrowByPoints(marker);
}

/// A cone is given by its base and its tip, which have the same box.
std::vector<Shape> shapesOf(const Arrow& arrow, const Eigen::Isometry3d& pose) {
  const auto along = [&](double distance) { return arrow.tail + distance * arrow.axes.col(2); };
  const double length = arrow.shaft_length;
  return {cylinder(pose, along(length / 2), arrow.axes, {arrow.shaft.x(), arrow.shaft.y(), length}),
          cylinder(pose, along(length), arrow.axes, {arrow.head.x(), arrow.head.y(), 0}),
          point(pose, along(length + arrow.head_length))};
}

Shape scaledPoints(const Marker& marker, const Eigen::Isometry3d& pose) {
  Shape shape{nullptr, Solid::kNone, Eigen::Vector3d::Zero(), pose};
  shape.link_from_shape.scale(toVector(marker.scale));
  return shape;
}

/// For lists, the shapes do not have their points yet.
std::vector<Shape> shapesOf(const Marker& marker) {
  const Eigen::Isometry3d pose = markerPose(marker);
  const auto solid = [&](Solid kind) { return Shape{nullptr, kind, toVector(marker.scale), pose}; };
  const auto ball = [&](double diameter) {
    return Shape{nullptr, Solid::kEllipsoid, Eigen::Vector3d::Constant(diameter), pose};
  };
  switch (marker.type) {
    case Marker::ARROW:
      return shapesOf(arrowOf(marker), pose);
    case Marker::CUBE:
    case Marker::CUBE_LIST:
      return {solid(Solid::kBox)};
    case Marker::SPHERE:
    case Marker::SPHERE_LIST:
      return {solid(Solid::kEllipsoid)};
    case Marker::CYLINDER:
      return {solid(Solid::kCylinder)};
    case Marker::LINE_STRIP:
    case Marker::LINE_LIST:
      return {ball(marker.scale.x)};
    case Marker::POINTS:
      return {ball(length(marker.scale.x, marker.scale.y))};
    case Marker::TRIANGLE_LIST:
    case Marker::MESH_RESOURCE:
      return {scaledPoints(marker, pose)};
    default:
      return {};
  }
}

Drawing drawingOf(const Marker& marker) {
  switch (marker.type) {
    case Marker::ARROW:
      return {DrawingKind::kArrow, arrowOf(marker).head_length};
    case Marker::LINE_LIST:
      return {DrawingKind::kSegments};
    case Marker::LINE_STRIP:
      return {DrawingKind::kStrip};
    case Marker::CUBE_LIST:
    case Marker::SPHERE_LIST:
    case Marker::POINTS:
      return {DrawingKind::kPoints};
    case Marker::TRIANGLE_LIST:
      return {DrawingKind::kTriangles};
    case Marker::MESH_RESOURCE:
      return {DrawingKind::kMesh};
    default:
      return {};
  }
}

}  // namespace

bool isList(const visualization_msgs::Marker& marker) {
  switch (marker.type) {
    case Marker::LINE_STRIP:
    case Marker::LINE_LIST:
    case Marker::CUBE_LIST:
    case Marker::SPHERE_LIST:
    case Marker::POINTS:
    case Marker::TRIANGLE_LIST:
      return true;
    default:
      return false;
  }
}

bool hasShape(const Marker& marker) {
  return marker.type != Marker::TEXT_VIEW_FACING;
}

Eigen::Isometry3d markerPose(const Marker& marker) {
  const geometry_msgs::Quaternion& q = marker.pose.orientation;
  Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  const double largest = rotation.coeffs().cwiseAbs().maxCoeff();
  if (largest > 0) {
    rotation.coeffs() /= largest;  // squares of huge or tiny numbers overflow or vanish
    rotation.normalize();
  } else {
    rotation.setIdentity();
  }
  Eigen::Isometry3d pose(rotation);
  pose.translation() = toVector(marker.pose.position);
  return pose;
}

MarkerShape markerShape(Marker&& marker) {
  const bool is_mesh = marker.type == Marker::MESH_RESOURCE;
  MarkerShape result{shapesOf(marker), is_mesh ? marker.mesh_resource : "", drawingOf(marker)};
  if (isList(marker)) result.shapes.front().points = pointSet(std::move(marker.points));
  return result;
}

}  // namespace link_bounds

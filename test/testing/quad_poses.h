// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses and boxes of links in quadruple precision, from their definition in URDF and the values of
// joints.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "link_bounds/robot/urdf/robot.h"
#include "testing/quad.h"

namespace link_bounds {

using QuadMatrix = Eigen::Matrix<Quad, 3, 3>;
using QuadColumn = Eigen::Matrix<Quad, 3, 1>;

struct QuadPose {
  QuadMatrix linear = QuadMatrix::Identity();
  QuadColumn translation = QuadColumn::Zero();

  QuadPose operator*(const QuadPose& other) const {
    return {linear * other.linear, linear * other.translation + translation};
  }
  QuadColumn operator*(const QuadColumn& point) const { return linear * point + translation; }
};

template <class Pose>
QuadPose toQuad(const Pose& pose) {
  return {pose.linear().template cast<Quad>(), pose.translation().template cast<Quad>()};
}

/// About the axis, or along it.
inline QuadPose quadMotion(const Joint& joint, double value) {
  QuadPose pose;
  const QuadColumn axis = joint.axis.cast<Quad>();
  if (joint.motion == Motion::kTranslation) pose.translation = axis * Quad(value);
  if (joint.motion != Motion::kRotation) return pose;
  Quad angle = value;
  int halvings = 0;
  for (; std::abs(static_cast<double>(angle)) > 0.5; ++halvings)
    angle /= 2;
  Quad sine = quadSine(angle);
  Quad cosine = quadRoot(1 - sine * sine);
  for (; halvings > 0; --halvings) {
    const Quad doubled = 2 * sine * cosine;
    cosine = 1 - 2 * sine * sine;
    sine = doubled;
  }
  const QuadColumn n = axis / quadRoot(axis.dot(axis));
  QuadMatrix cross;
  cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  pose.linear = QuadMatrix::Identity() + cross * sine + cross * cross * (1 - cosine);
  return pose;
}

/// In the frame of the root link; one value per joint of a robot with simple joints.
inline std::vector<QuadPose> quadLinkPoses(const Robot& robot, const std::vector<double>& values) {
  std::vector<QuadPose> poses(robot.links.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    poses[joint.child] =
        poses[joint.parent] * toQuad(joint.parent_from_joint) * quadMotion(joint, values[i]);
  }
  return poses;
}

/// How far a solid extends along a direction from its center.
inline Quad quadHalfExtent(const Shape& shape, const QuadColumn& direction) {
  Quad parts[3];
  for (int k = 0; k < 3; ++k) {
    const Quad part = direction[k] * static_cast<Quad>(shape.size[k]) / 2;
    parts[k] = part < 0 ? -part : part;
  }
  if (shape.solid == Solid::kBox) return parts[0] + parts[1] + parts[2];
  const Quad circle = parts[0] * parts[0] + parts[1] * parts[1];
  if (shape.solid == Solid::kCylinder) return quadRoot(circle) + parts[2];
  if (shape.solid == Solid::kEllipsoid) return quadRoot(circle + parts[2] * parts[2]);
  return 0;
}

/// Of no points.
inline QuadBox emptyQuadBox() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

/// By the solid of a shape around each of these points.
inline void extend(QuadBox& box, const Shape& shape, const QuadPose& placed,
                   const std::vector<Eigen::Vector3d>& points) {
  for (const Eigen::Vector3d& point : points) {
    const QuadColumn center = placed * QuadColumn(point.cast<Quad>());
    for (int k = 0; k < 3; ++k) {
      const Quad half = quadHalfExtent(shape, placed.linear.row(k));
      const auto i = static_cast<std::size_t>(k);
      box.min[i] = std::min<Quad>(box.min[i], center[k] - half);
      box.max[i] = std::max<Quad>(box.max[i], center[k] + half);
    }
  }
}

/// The points of a shape; of a solid alone its center.
inline std::vector<Eigen::Vector3d> centersOf(const Shape& shape) {
  if (!shape.points) return {Eigen::Vector3d::Zero()};
  return shape.points->keptPoints();
}

}  // namespace link_bounds

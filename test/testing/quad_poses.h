// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses and boxes of links in quadruple precision, from the values of joints.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "link_bounds/robot/urdf/robot.h"
#include "testing/quad.h"

namespace link_bounds {

/// A 3 x 3 matrix and a translation.
struct QuadPose {
  Quad linear[3][3];
  Quad translation[3];
};

inline QuadPose quadPose(const Eigen::Affine3d& pose) {
  QuadPose result;
  for (int i = 0; i < 3; ++i) {
    result.translation[i] = pose.translation()[i];
    for (int j = 0; j < 3; ++j)
      result.linear[i][j] = pose.linear()(i, j);
  }
  return result;
}

inline QuadPose operator*(const QuadPose& a, const QuadPose& b) {
  QuadPose result;
  for (int i = 0; i < 3; ++i) {
    result.translation[i] = a.translation[i];
    for (int k = 0; k < 3; ++k)
      result.translation[i] += a.linear[i][k] * b.translation[k];
    for (int j = 0; j < 3; ++j) {
      result.linear[i][j] = 0;
      for (int k = 0; k < 3; ++k)
        result.linear[i][j] += a.linear[i][k] * b.linear[k][j];
    }
  }
  return result;
}

/// About the axis, or along it.
inline QuadPose quadJointMotion(const Joint& joint, double value) {
  QuadPose result = quadPose(Eigen::Affine3d::Identity());
  if (joint.motion == Motion::kTranslation) {
    for (int i = 0; i < 3; ++i)
      result.translation[i] = static_cast<Quad>(joint.axis[i]) * static_cast<Quad>(value);
  }
  if (joint.motion != Motion::kRotation) return result;
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
  Quad square = 0;
  for (int i = 0; i < 3; ++i)
    square += static_cast<Quad>(joint.axis[i]) * static_cast<Quad>(joint.axis[i]);
  Quad n[3];
  for (int i = 0; i < 3; ++i)
    n[i] = static_cast<Quad>(joint.axis[i]) / quadRoot(square);
  const Quad cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      result.linear[i][j] =
          (i == j ? cosine : Quad(0)) + sine * cross[i][j] + (1 - cosine) * n[i] * n[j];
  }
  return result;
}

/// How far a solid extends along a direction from its center.
inline Quad quadHalfExtent(const Shape& shape, const Quad (&row)[3]) {
  Quad parts[3];
  for (int k = 0; k < 3; ++k) {
    const Quad part = row[k] * static_cast<Quad>(shape.size[k]) / 2;
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
    for (int k = 0; k < 3; ++k) {
      Quad center = placed.translation[k];
      for (int j = 0; j < 3; ++j)
        center += placed.linear[k][j] * static_cast<Quad>(point[j]);
      const Quad half = quadHalfExtent(shape, placed.linear[k]);
      const auto i = static_cast<std::size_t>(k);
      box.min[i] = std::min(box.min[i], center - half);
      box.max[i] = std::max(box.max[i], center + half);
    }
  }
}

/// The points of a shape; of a solid alone its center.
inline std::vector<Eigen::Vector3d> centersOf(const Shape& shape) {
  if (!shape.points) return {Eigen::Vector3d::Zero()};
  return shape.points->keptPoints();
}

}  // namespace link_bounds

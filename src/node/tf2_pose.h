// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses in tf2's arithmetic: what it does with a quaternion that is not quite of length 1 counts.
#pragma once

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/LinearMath/Vector3.h>

#include <Eigen/Geometry>
#include <array>

namespace link_bounds {

/// A rotation, then a translation; kept as a geometry_msgs/Transform is sent, so that it can be
/// copied from there to a history in one piece.
struct Tf2Pose {
  Tf2Pose() = default;
  Tf2Pose(const tf2::Quaternion& q, const tf2::Vector3& t)
      : numbers{t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()} {}

  tf2::Quaternion rotation() const { return {numbers[3], numbers[4], numbers[5], numbers[6]}; }
  tf2::Vector3 translation() const { return {numbers[0], numbers[1], numbers[2]}; }

  std::array<double, 7> numbers{0, 0, 0, 0, 0, 0, 1};
};

inline Tf2Pose operator*(const Tf2Pose& a, const Tf2Pose& b) {
  return {a.rotation() * b.rotation(),
          tf2::quatRotate(a.rotation(), b.translation()) + a.translation()};
}

inline Tf2Pose inverse(const Tf2Pose& pose) {
  const tf2::Quaternion rotation = pose.rotation().inverse();
  return {rotation, tf2::quatRotate(rotation, -pose.translation())};
}

/// Number by number; what is not a number differs from everything.
inline bool isSame(const Tf2Pose& a, const Tf2Pose& b) {
  return a.numbers == b.numbers;
}

/// A rotation whatever the length of the quaternion, as tf2::Matrix3x3 makes it.
inline Eigen::Affine3d toAffine(const Tf2Pose& pose) {
  const tf2::Quaternion q = pose.rotation();
  const tf2::Vector3 t = pose.translation();
  const double scale = 2 / q.length2();
  const double x = q.x() * scale, y = q.y() * scale, z = q.z() * scale;
  const double wx = q.w() * x, wy = q.w() * y, wz = q.w() * z;
  const double xx = q.x() * x, xy = q.x() * y, xz = q.x() * z;
  const double yy = q.y() * y, yz = q.y() * z, zz = q.z() * z;
  Eigen::Affine3d result;
  result.matrix() << 1 - (yy + zz), xy - wz, xz + wy, t.x(),  //
      xy + wz, 1 - (xx + zz), yz - wx, t.y(),                 //
      xz - wy, yz + wx, 1 - (xx + yy), t.z(),                 //
      0, 0, 0, 1;
  return result;
}

}  // namespace link_bounds

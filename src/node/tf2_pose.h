// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses in tf2's arithmetic: what it does with a quaternion that is not quite of length 1 counts.
#pragma once

#include <tf2/LinearMath/Matrix3x3.h>
#include <tf2/LinearMath/Quaternion.h>
#include <tf2/LinearMath/Vector3.h>

#include <Eigen/Geometry>

namespace link_bounds {

/// A rotation, then a translation.
struct Tf2Pose {
  tf2::Quaternion rotation{0, 0, 0, 1};
  tf2::Vector3 translation{0, 0, 0};
};

inline Tf2Pose operator*(const Tf2Pose& a, const Tf2Pose& b) {
  return {a.rotation * b.rotation, tf2::quatRotate(a.rotation, b.translation) + a.translation};
}

inline Tf2Pose inverse(const Tf2Pose& pose) {
  const tf2::Quaternion rotation = pose.rotation.inverse();
  return {rotation, tf2::quatRotate(rotation, -pose.translation)};
}

/// Number by number; what is not a number differs from everything.
inline bool isSame(const Tf2Pose& a, const Tf2Pose& b) {
  const tf2::Quaternion& p = a.rotation;
  const tf2::Quaternion& q = b.rotation;
  const tf2::Vector3& s = a.translation;
  const tf2::Vector3& t = b.translation;
  return p.x() == q.x() && p.y() == q.y() && p.z() == q.z() && p.w() == q.w() && s.x() == t.x() &&
         s.y() == t.y() && s.z() == t.z();
}

/// A rotation whatever the length of the quaternion.
inline Eigen::Affine3d toAffine(const Tf2Pose& pose) {
  const tf2::Matrix3x3 rows(pose.rotation);
  Eigen::Affine3d result;
  for (int column = 0; column < 3; ++column) {
    const tf2::Vector3 entries = rows.getColumn(column);
    result.matrix().col(column) << entries.x(), entries.y(), entries.z(), 0;
  }
  result.matrix().col(3) << pose.translation.x(), pose.translation.y(), pose.translation.z(), 1;
  return result;
}

}  // namespace link_bounds

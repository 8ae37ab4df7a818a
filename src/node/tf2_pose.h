// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses in tf2's arithmetic: what it does with a quaternion that is not quite of length 1 counts.
#pragma once

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

/// With the quaternion normalised.
inline Eigen::Isometry3d toIsometry(const Tf2Pose& pose) {
  const tf2::Quaternion& q = pose.rotation;
  const tf2::Vector3& t = pose.translation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
  result.translation() = Eigen::Vector3d(t.x(), t.y(), t.z());
  return result;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses in tf2's arithmetic, in which a quaternion that is not quite of length 1 also scales.
#pragma once

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/LinearMath/Vector3.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace link_bounds {

/// tf2 computes an angle from its cosine, which is wrong by a few 1e-16: the angle is then wrong by
/// less than this [rad].
constexpr double kAngleError = 1e-7;

/// Rounding makes a quaternion that tf2 interpolates longer by less than this.
constexpr double kLengthError = 1e-14;

/// A rotation, then a translation. Stored as a geometry_msgs/Transform is serialised, so that one
/// copy brings it from the message to the history.
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

/// A pose with its matrix, from which boxes and the poses of child frames are computed.
struct MatrixPose {
  MatrixPose() = default;
  explicit MatrixPose(const Tf2Pose& pose) { set(pose.rotation(), pose.translation()); }

  /// The matrix is a rotation for any length of the quaternion, as in tf2::Matrix3x3.
  void set(const tf2::Quaternion& q, const tf2::Vector3& t) {
    rotation = q;
    length2 = q.length2();
    const double scale = 2 / length2;
    const double x = q.x() * scale, y = q.y() * scale, z = q.z() * scale;
    const double wx = q.w() * x, wy = q.w() * y, wz = q.w() * z;
    const double xx = q.x() * x, xy = q.x() * y, xz = q.x() * z;
    const double yy = q.y() * y, yz = q.y() * z, zz = q.z() * z;
    Eigen::Matrix4d& m = affine.matrix();
    m.col(0) << 1 - (yy + zz), xy + wz, xz - wy, 0;
    m.col(1) << xy - wz, 1 - (xx + zz), yz + wx, 0;
    m.col(2) << xz + wy, yz - wx, 1 - (xx + yy), 0;
    m.col(3) << t.x(), t.y(), t.z(), 1;
  }

  /// Sets this to a * b. False if it has that value already. In tf2 a quaternion that is not of
  /// length 1 scales the vector that it turns.
  bool setProduct(const MatrixPose& a, const Tf2Pose& b) {
    const tf2::Vector3 t = b.translation();
    const Eigen::Matrix4d& m = a.affine.matrix();
    const auto moved = [&](int k) {
      return (m(k, 0) * t.x() + m(k, 1) * t.y() + m(k, 2) * t.z()) * a.length2 + m(k, 3);
    };
    return change(a.rotation * b.rotation(), {moved(0), moved(1), moved(2)});
  }

  /// Sets this to the pose. False if it has that value already.
  bool change(const tf2::Quaternion& q, const tf2::Vector3& t) {
    if (isAt(q, t)) return false;
    set(q, t);
    return true;
  }

  /// Compares numbers exactly; q and -q are the same rotation. NaN differs from everything.
  bool isAt(const tf2::Quaternion& q, const tf2::Vector3& t) const {
    const auto is_turned = [&](double sign) {
      return q.x() == sign * rotation.x() && q.y() == sign * rotation.y() &&
             q.z() == sign * rotation.z() && q.w() == sign * rotation.w();
    };
    return t.x() == affine(0, 3) && t.y() == affine(1, 3) && t.z() == affine(2, 3) &&
           (is_turned(1) || is_turned(-1));
  }

  tf2::Vector3 translation() const { return {affine(0, 3), affine(1, 3), affine(2, 3)}; }

  tf2::Quaternion rotation = tf2::Quaternion::getIdentity();
  double length2 = 1;  ///< squared length of the quaternion
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
};

/// Sets `result` to the transform that tf2's arithmetic applies. False if it is not finite, or if
/// the quaternion is not of length 1: tf2 would scale by it, which no joint does.
inline bool toIsometry(const Tf2Pose& pose, Eigen::Isometry3d& result) {
  constexpr double kMaxLengthError = 1e-6;
  const MatrixPose matrix(pose);
  result.matrix() = matrix.affine.matrix();
  return std::abs(matrix.length2 - 1) <= kMaxLengthError && result.matrix().allFinite();
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The checks of tf2's setTransform, without its line of output per refused transform.
#include "world/tf/transform_refusal.h"

#include <cmath>
#include <cstdint>

namespace link_bounds {
namespace {

/// QUATERNION_NORMALIZATION_TOLERANCE of tf2, for the squared length.
constexpr double kNormTolerance = 0.01;

/// tf2 adds its ten seconds of history to a stamp and throws if the seconds exceed 32 bits.
constexpr std::uint32_t kLastSecond = UINT32_MAX - 11;
constexpr std::uint32_t kLastNanosecond = 999999999;

/// A sum of squares is NaN only if one of them is.
bool hasNan(const Tf2Pose& pose) {
  return std::isnan(pose.rotation().length2() + pose.translation().length2());
}

bool isUnit(const tf2::Quaternion& q) {
  return std::abs(q.length2() - 1) < kNormTolerance;
}

}  // namespace

const char* whyRefused(const TransformView& transform) {
  if (transform.child.empty()) return "child_frame_id is empty; name the frame";
  if (transform.parent.empty()) return "header.frame_id is empty; name the parent frame";
  if (hasNan(transform.parent_from_child))
    return "it has a NaN (not a number); correct the publisher";
  if (!isUnit(transform.parent_from_child.rotation())) {
    return "the length of its quaternion is not 1; normalise it";
  }
  const ros::Time stamp = transform.stamp;
  if (stamp.sec > kLastSecond || stamp.nsec > kLastNanosecond) {
    return "its stamp is no time that tf can handle; correct the publisher's clock";
  }
  return nullptr;
}

}  // namespace link_bounds

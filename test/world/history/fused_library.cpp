// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A tf2 as compiled for 64-bit ARM, on any machine: this part of the library replaces the installed
// one in the test that it is linked with.
#include <tf2/time_cache.h>

#include <algorithm>
#include <cmath>

namespace tf2 {
namespace {

double fusedDot(const Quaternion& a, const Quaternion& b) {
  const double xy = std::fma(a.x(), b.x(), a.y() * b.y());
  return std::fma(a.w(), b.w(), std::fma(a.z(), b.z(), xy));
}

/// As Quaternion::slerp. The sign is not fused: after exactly half a turn it would be another one,
/// and the way there would be a matter of chance.
Quaternion fusedSlerp(const Quaternion& from, const Quaternion& to, double ratio) {
  const double dot = fusedDot(from, to);
  const double sign = from.dot(to) < 0 ? -1 : 1;
  const double angle =
      std::acos(std::min(1.0, std::abs(dot) / std::sqrt(fusedDot(from, from) * fusedDot(to, to))));
  if (angle == 0) return from;
  return from * (std::sin((1 - ratio) * angle) / std::sin(angle)) +
         to * (sign * std::sin(ratio * angle) / std::sin(angle));
}

}  // namespace

/// Of the stored transforms the newest one is the first.
bool TimeCache::getData(ros::Time time, TransformStorage& result, std::string*) {
  if (storage_.empty() || time > storage_.front().stamp_ || time < storage_.back().stamp_)
    return false;
  auto older = storage_.begin();
  while (older->stamp_ > time)
    ++older;
  result = *older;
  if (older->stamp_ == time) return true;
  const TransformStorage& newer = *std::prev(older);
  const double ratio = (time - older->stamp_).toSec() / (newer.stamp_ - older->stamp_).toSec();
  result.rotation_ = fusedSlerp(older->rotation_, newer.rotation_, ratio);
  result.translation_.setInterpolate3(older->translation_, newer.translation_, ratio);
  result.stamp_ = time;
  return true;
}

}  // namespace tf2

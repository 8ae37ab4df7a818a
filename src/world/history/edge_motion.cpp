// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/history/edge_motion.h"

#include <tf2/time_cache.h>

namespace link_bounds {
namespace {

tf2::TransformStorage stored(const Tf2Pose& pose, double stamp) {
  tf2::TransformStorage result;
  result.rotation_ = pose.rotation();
  result.translation_ = pose.translation();
  result.stamp_ = ros::Time(stamp);
  result.frame_id_ = result.child_frame_id_ = 0;  // tf2 compares them, but does not set them
  return result;
}

/// EdgeStep::is_sudden according to the tf2 library.
bool isSuddenInLibrary(const Tf2Pose& older, const Tf2Pose& newer) {
  tf2::TimeCache cache;
  cache.insertData(stored(older, 1));
  cache.insertData(stored(newer, 3));
  tf2::TransformStorage middle;
  return cache.getData(ros::Time(2), middle) && middle.rotation_ == older.rotation();
}

/// Interpolates linearly, which equals slerp for quaternions of nearly the same rotation.
tf2::Quaternion between(const tf2::Quaternion& older, const tf2::Quaternion& newer, double part) {
  const double sign = older.dot(newer) < 0 ? -1 : 1;
  return older * (1 - part) + newer * (sign * part);
}

}  // namespace

void EdgeMotion::seek(std::int64_t time) {
  std::size_t place = time < older().stamp ? 0 : place_;
  while (place + 1 < samples_.size() && samples_[place + 1]->stamp <= time)
    ++place;
  if (place == place_) return;
  place_ = place;
  motion_.reset();
}

/// Made on first use, because poses at samples do not need it.
const EdgeMotion::Motion& EdgeMotion::motion() const {
  if (motion_) return *motion_;
  const Tf2Pose& from = older().parent_from_child;
  const Tf2Pose& to = hasNext() ? newer().parent_from_child : from;
  const EdgeStep step = stepBetween(from, to);
  const bool is_ambiguous = step.is_jump_partial && isSuddenInLibrary(from, to) != step.is_sudden;
  return motion_.emplace(Motion{step, is_ambiguous});
}

Tf2Pose EdgeMotion::at(std::int64_t time) const {
  const Tf2Pose& from = older().parent_from_child;
  if (!hasNext() || time <= older().stamp) return from;
  const Tf2Pose pose = interpolated(older(), newer(), time);
  if (!isLibraryOther()) return pose;
  if (!motion().step.is_sudden) return {from.rotation(), pose.translation()};
  const tf2::Quaternion to = newer().parent_from_child.rotation();
  return {between(from.rotation(), to, partOf(time - older().stamp)), pose.translation()};
}

double EdgeMotion::partOf(std::int64_t duration) const {
  return static_cast<double>(duration) / static_cast<double>(newer().stamp - older().stamp);
}

EdgeStep EdgeMotion::stepIn(std::int64_t duration) const {
  const EdgeStep& step = motion().step;
  return hasNext() ? step.in(partOf(duration)) : step;
}

}  // namespace link_bounds

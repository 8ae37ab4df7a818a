// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A placement is kept in the fixed frame of its time.
#include "world/bodies/object_placer.h"

namespace link_bounds {
namespace {

/// How long to wait for a transform if nothing ever becomes stale [ROS s].
constexpr double kPatience = 10;

}  // namespace

ObjectPose ObjectPlacer::place(LiveObject& object, ros::Time now) {
  if (object.header) {
    const FramePose& header = object.header.pose();
    return {header.problem, header.fixed_from_frame.affine, olderStamp(header.stamp, object.stamp)};
  }
  if (!object.placement && object.problem == TransformProblem::kGivenUp)
    return {TransformProblem::kGivenUp};
  if (!object.placement || object.is_sent_again) {
    if (!placeOnce(object, now)) return {TransformProblem::kWaiting};
    if (!object.placement) return {TransformProblem::kGivenUp};
  }
  const std::optional<Eigen::Affine3d> pose = carried(*object.placement);
  if (!pose) return {TransformProblem::kNotCarried};
  return {TransformProblem::kNone, *pose, object.stamp};
}

/// False while it waits for the transform at its stamp. If that does not come, an earlier placement
/// stays.
bool ObjectPlacer::placeOnce(LiveObject& object, ros::Time now) {
  const std::int64_t stamp = object.content->stamp;
  const auto pose = poseAt(stamp, object.frame);
  if (pose) {
    object.placement = ObjectPlacement{*frames_.fixedFrame(), *pose};
    if (object.is_sent_again) {
      object.stamp = stamp;
      object.is_outdated = false;
    }
  } else if (!hasWaitedLong(object.waiting_since, now)) {
    const bool may_come = static_cast<std::int64_t>(now.toNSec()) - stamp <= EdgeHistory::kLength;
    if (!object.placement || may_come) return false;
  }
  object.is_sent_again = false;
  return true;
}

std::optional<Eigen::Affine3d> ObjectPlacer::poseAt(std::int64_t stamp, Frame frame) {
  const Frame fixed_frame = *frames_.fixedFrame();
  const std::uint64_t version = frames_.tf().version();
  const bool is_known = past_pose_ && past_pose_->fixed_frame == fixed_frame &&
                        past_pose_->frame == frame && past_pose_->stamp == stamp &&
                        past_pose_->tf_version == version;
  if (!is_known) {
    past_pose_ = PastPose{fixed_frame, frame, stamp, version, std::nullopt};
    const std::optional<Tf2Pose> pose = frames_.tf().pose(fixed_frame, frame, stamp);
    if (pose) past_pose_->fixed_from_frame = MatrixPose(*pose).affine;
  }
  return past_pose_->fixed_from_frame;
}

bool ObjectPlacer::hasWaitedLong(std::int64_t since, ros::Time now) const {
  const double patience = frames_.timeout() > 0 ? frames_.timeout() : kPatience;
  const auto waited = static_cast<std::int64_t>(now.toNSec()) - since;
  return static_cast<double>(waited) > patience * 1e9;
}

/// Fixed from header frame, if the placement is known in the present fixed frame.
std::optional<Eigen::Affine3d> ObjectPlacer::carried(const ObjectPlacement& placement) const {
  if (placement.fixed_frame == frames_.fixedFrame()) return placement.fixed_from_header;
  const std::optional<Eigen::Affine3d>& carry = carries_.at(placement.fixed_frame).fixed_from_old;
  if (!carry) return std::nullopt;
  return *carry * placement.fixed_from_header;
}

void ObjectPlacer::carryFrom(const std::vector<Frame>& old_fixed_frames) {
  carries_.clear();
  for (const Frame frame : old_fixed_frames) {
    if (frame != frames_.fixedFrame() && carries_.count(frame) == 0)
      carries_.emplace(frame, Carry{frames_.follow(frame), std::nullopt});
  }
}

/// Poses that are stale or not finite are not used, because a carry stays.
bool ObjectPlacer::findCarries() {
  bool is_found = false;
  for (auto& [frame, carry] : carries_) {
    if (carry.fixed_from_old) continue;
    const FramePose& pose = carry.old_frame.pose();
    const Eigen::Affine3d& affine = pose.fixed_from_frame.affine;
    if (pose.problem != TransformProblem::kNone || !affine.matrix().allFinite()) continue;
    carry.fixed_from_old = affine;
    carry.old_frame = FrameTracker::Handle();
    is_found = true;
  }
  return is_found;
}

}  // namespace link_bounds

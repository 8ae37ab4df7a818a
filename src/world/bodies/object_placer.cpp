// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A placement stays in the fixed frame in which it was made, and is transformed when it is read.
#include "world/bodies/object_placer.h"

#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

/// How long to wait for a transform if the timeout is 0, so that nothing becomes stale [ROS s].
constexpr double kUnknownTimeout = 10;

}  // namespace

ObjectPose ObjectPlacer::place(LiveObject& object, ros::Time now) {
  if (object.header) {
    const FramePose& header = object.header.pose();
    if (header.problem != TransformProblem::kNone) return {header.problem};
    return {header.problem, header.fixed_from_frame.affine, olderStamp(header.stamp, object.stamp)};
  }
  TransformProblem problem = TransformProblem::kNone;
  if (!object.placement || object.placement->is_earlier) problem = placeOnce(object, now);
  if (!object.placement) return {problem};
  const std::optional<Eigen::Affine3d> pose = carried(*object.placement);
  if (!pose && problem == TransformProblem::kNone) problem = TransformProblem::kNotCarried;
  return {problem, pose, object.stamp};
}

/// Places the object by the transform at its stamp. Without one: kWaiting as long as it may come.
/// After that an earlier placement stays; if there is none, kGivenUp.
TransformProblem ObjectPlacer::placeOnce(LiveObject& object, ros::Time now) {
  if (object.problem == TransformProblem::kGivenUp) return object.problem;
  const std::int64_t stamp = object.content->stamp;
  const bool is_known = knowsTimeOf(object);
  if (const auto pose = is_known ? poseAt(stamp, object.frame) : std::nullopt) {
    if (object.placement) object.stamp = stamp;
    object.placement = ObjectPlacement{*frames_.fixedFrame(), *pose};
    return TransformProblem::kNone;
  }
  const bool is_in_tf = nanosecondsOf(now) - stamp <= EdgeHistory::kLength;
  const bool may_come = !object.placement || (is_known && is_in_tf);
  if (may_come && !hasWaitedLong(object.waiting_since, now)) return TransformProblem::kWaiting;
  if (!object.placement) return TransformProblem::kGivenUp;
  object.placement->is_earlier = false;
  object.stamp_time = StampTime::kNotSent;
  return TransformProblem::kNone;
}

/// Whether tf can be of the same side of a clock jump as the object's stamp. Static transforms are
/// valid at any time.
bool ObjectPlacer::knowsTimeOf(const LiveObject& object) {
  if (object.stamp_time != StampTime::kNotSent || object.frame == *frames_.fixedFrame())
    return true;
  const FrameTracker::Handle header = frames_.follow(object.frame);
  return header.pose().problem == TransformProblem::kNone && header.pose().stamp == 0;
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
  const double patience = frames_.timeout() > 0 ? frames_.timeout() : kUnknownTimeout;
  const auto waited = nanosecondsOf(now) - since;
  return static_cast<double>(waited) > patience * 1e9;
}

/// The pose fixed_from_header in the current fixed frame, if the transform to it is known.
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

/// Ignores poses that are stale or not finite, because a transform that was found is kept.
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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A second tracker over the same transforms.
#include "tools/bag_bounds/watch/frame_view.h"

#include <algorithm>
#include <utility>

namespace link_bounds {
namespace {

/// Frames of objects that are gone are followed until there are so many.
constexpr std::size_t kMaxFollowed = 1000;

}  // namespace

FrameView::FrameView(const std::string& frame, Scene& scene, TransformBuffer& tf, ros::Time now)
    : scene_(scene), frames_(tf), links_(frames_) {
  frames_.setTarget(frame, scene.model()->parameters.timeout, now);
  links_.adopt(scene.links.sharedModel());
}

bool FrameView::update(ros::Time now) {
  if (followed_.size() > kMaxFollowed) followed_.clear();
  frames_.update(now);
  return links_.update();
}

bool FrameView::expire(ros::Time now) {
  frames_.expire(now);
  return links_.update();
}

const FramePose& FrameView::poseOf(const std::string& frame) {
  auto found = followed_.find(frame);
  if (found == followed_.end()) {
    TransformBuffer::Hold hold(frames_.tf(), frame);
    FrameTracker::Handle handle = frames_.follow(hold.frame());
    found = followed_.emplace(frame, Followed{std::move(hold), std::move(handle)}).first;
  }
  return found->second.handle.pose();
}

FrameView::Placed FrameView::placed(const SceneBody& body) {
  if (body.link) {
    const BoxState& state = links_.states()[*body.link];
    return {state, state.stamp};
  }
  Placed result;
  BoxState& state = result.state;
  if (!body.state.box) return result;
  const BoxSource source = scene_.boxSource(body);
  const FramePose& pose = poseOf(frames_.tf().name(source.frame));
  if (pose.problem != TransformProblem::kNone) return result;
  result.pose_stamp = pose.stamp;
  const Eigen::Affine3d& frame_pose = pose.fixed_from_frame.affine;
  state.box = linkBox(source.bounded,
                      source.frame_from_body ? frame_pose * *source.frame_from_body : frame_pose);
  state.stamp = std::max(pose.stamp, body.state.stamp);
  state.incomplete = body.state.incomplete || !state.box;
  return result;
}

}  // namespace link_bounds

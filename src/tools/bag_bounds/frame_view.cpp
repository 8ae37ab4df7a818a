// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A second tracker over the same transforms.
#include "tools/bag_bounds/frame_view.h"

#include <algorithm>

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
  if (found == followed_.end()) found = followed_.emplace(frame, frames_.follow(frame)).first;
  return found->second.pose();
}

FrameView::Placed FrameView::placed(const LiveObject& object) {
  Placed result;
  BoxState& state = result.state;
  if (!object.state.box) return result;
  const ObjectContent& content = *object.boxed.content;
  const FramePose& pose = poseOf(content.follows() ? content.frame : scene_.model()->fixed_frame);
  if (pose.problem != TransformProblem::kNone) return result;
  result.pose_stamp = pose.stamp;
  state.box = linkBox(content.bounded, content.follows() ? pose.fixed_from_frame.affine
                                                         : pose.fixed_from_frame.affine *
                                                               object.boxed.fixed_from_header);
  state.stamp = std::max(pose.stamp, object.state.stamp);
  state.incomplete = object.state.incomplete || !state.box;
  return result;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A path, and a pose as fresh as the edges of that path, which may have been others at its time.
#include "node/tf/followed_frame.h"

#include <algorithm>

namespace link_bounds {

bool FollowedFrame::update(const Target& target, const TransformSource& tf, ros::Time now,
                           bool paths_may_differ) {
  const bool path_differs = paths_may_differ && findPath(target, tf.tree());
  return (path_differs || was_elsewhere_ || isTouched(tf.tree())) && lookUp(target, tf, now);
}

bool FollowedFrame::refresh(const Target& target, const TransformSource& tf, ros::Time now) {
  findPath(target, tf.tree());
  return lookUp(target, tf, now);
}

bool FollowedFrame::expire(const Target& target, const TransformSource& tf, ros::Time now) {
  if (trouble_ != Trouble::kNone || !isStale(target, tf.tree(), now)) return false;
  trouble_ = Trouble::kStale;
  return true;
}

/// True if the path is another one than before.
bool FollowedFrame::findPath(const Target& target, const FrameTree& tree) {
  std::optional<std::vector<Frame>> path = tree.path(frame_, target.fixed_frame);
  const bool differs = path != path_;
  path_ = std::move(path);
  return differs;
}

/// The fixed frame itself has an empty path; tf2 stamps it by its own edge.
bool FollowedFrame::isTouched(const FrameTree& tree) const {
  if (!path_) return false;
  if (path_->empty()) return tree.isNews(frame_);
  return std::any_of(path_->begin(), path_->end(),
                     [&tree](Frame edge) { return tree.isNews(edge); });
}

bool FollowedFrame::isStale(const Target& target, const FrameTree& tree, ros::Time now) const {
  if (!path_) return false;
  const std::int64_t stale_before = staleBefore(target.timeout, now);
  return std::any_of(path_->begin(), path_->end(), [&](Frame edge) {
    return !tree.isStatic(edge) && tree.lastHeard(edge) < stale_before;
  });
}

bool FollowedFrame::lookUp(const Target& target, const TransformSource& tf, ros::Time now) {
  Trouble trouble = Trouble::kNone;
  std::optional<StampedPose> pose;
  if (isStale(target, tf.tree(), now)) {
    trouble = Trouble::kStale;
  } else {
    if (path_) pose = tf.latest(target.fixed_frame, frame_, *path_);
    if (!pose) trouble = Trouble::kNoTransform;
  }
  was_elsewhere_ = path_ && !tf.wasPath(*path_, tf.latestCommonTime(frame_, *path_));
  bool is_changed = trouble != trouble_;
  trouble_ = trouble;
  if (!pose) return is_changed;
  is_changed |= pose->stamp != pose_.stamp ||
                pose->world_from_link.matrix() != pose_.world_from_link.matrix();
  pose_ = *pose;
  return is_changed;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks up and bounds only the links on whose path a transform arrived.
#include "live_boxes.h"

#include <algorithm>

namespace link_bounds {
namespace {

bool isSame(const BoxState& a, const BoxState& b) {
  if (a.stamp != b.stamp || a.incomplete != b.incomplete) return false;
  if (!a.box || !b.box) return a.box.has_value() == b.box.has_value();
  return a.box->min() == b.box->min() && a.box->max() == b.box->max();
}

}  // namespace

void LiveBoxes::adopt(std::shared_ptr<const Model> model, TransformSource& tf, ros::Time now) {
  model_ = std::move(model);
  fixed_frame_ = tf.tree().frame(model_->fixed_frame);
  links_.assign(model_->links.size(), Link());
  states_.assign(model_->links.size(), BoxState());
  poses_.assign(model_->links.size(), Eigen::Isometry3d::Identity());
  reaches_.clear();
  for (const BoundedLink& link : model_->links)
    reaches_.emplace_back(link);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    links_[i].frame = tf.tree().frame(model_->frames[i]);
  }
  updateAll(tf, now);
}

bool LiveBoxes::updateAll(const TransformSource& tf, ros::Time now) {
  structure_ = tf.tree().structure();
  bool is_changed = false;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    findPath(links_[i], tf.tree());
    is_changed |= refresh(i, tf, now);
  }
  return is_changed;
}

bool LiveBoxes::update(const TransformSource& tf, ros::Time now) {
  const bool paths_may_differ = structure_ != tf.tree().structure();
  structure_ = tf.tree().structure();
  bool is_changed = false;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const bool path_differs = paths_may_differ && findPath(links_[i], tf.tree());
    if (path_differs || isTouched(links_[i], tf.tree())) is_changed |= refresh(i, tf, now);
  }
  return is_changed;
}

bool LiveBoxes::expire(const TransformSource& tf, ros::Time now) {
  bool is_changed = false;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    if (link.trouble != Trouble::kStale && isStale(link, tf.tree(), now)) {
      is_changed |= refresh(i, tf, now);
    }
  }
  return is_changed;
}

/// True if the path is another one than before.
bool LiveBoxes::findPath(Link& link, const FrameTree& tree) const {
  std::optional<std::vector<FrameTree::Frame>> path = tree.path(link.frame, fixed_frame_);
  const bool differs = path != link.path;
  link.path = std::move(path);
  return differs;
}

/// The fixed frame itself has an empty path; tf2 stamps it by its own edge.
bool LiveBoxes::isTouched(const Link& link, const FrameTree& tree) const {
  if (!link.path) return false;
  if (link.path->empty()) return tree.isNews(link.frame);
  return std::any_of(link.path->begin(), link.path->end(),
                     [&tree](FrameTree::Frame edge) { return tree.isNews(edge); });
}

bool LiveBoxes::isStale(const Link& link, const FrameTree& tree, ros::Time now) const {
  const double timeout = model_->parameters.timeout;
  if (timeout <= 0 || !link.path) return false;
  const double now_ns = static_cast<double>(now.toNSec());
  return std::any_of(link.path->begin(), link.path->end(), [&](FrameTree::Frame edge) {
    return !tree.isStatic(edge) &&
           now_ns - static_cast<double>(tree.lastHeard(edge)) > timeout * 1e9;
  });
}

bool LiveBoxes::refresh(std::size_t i, const TransformSource& tf, ros::Time now) {
  BoxState state;
  const Trouble trouble = place(i, tf, now, state);
  state.incomplete = trouble != Trouble::kNone || !model_->links[i].isWhole();
  const bool is_changed = trouble != links_[i].trouble || !isSame(state, states_[i]);
  links_[i].trouble = trouble;
  states_[i] = state;
  return is_changed;
}

LiveBoxes::Trouble LiveBoxes::place(std::size_t i, const TransformSource& tf, ros::Time now,
                                    BoxState& state) {
  const BoundedLink& link = model_->links[i];
  if (link.shapes.empty()) return Trouble::kNone;
  if (!links_[i].path) return Trouble::kNoTransform;
  if (isStale(links_[i], tf.tree(), now)) return Trouble::kStale;
  const std::optional<StampedPose> pose = tf.latest(fixed_frame_, links_[i].frame, *links_[i].path);
  if (!pose) return Trouble::kNoTransform;
  state.box = linkBox(link, pose->world_from_link, reaches_[i]);
  if (!state.box) return Trouble::kPoseNotFinite;
  state.stamp = pose->stamp;
  poses_[i] = pose->world_from_link;
  return Trouble::kNone;
}

std::string LiveBoxes::reason(std::size_t i) const {
  const std::string& missing = model_->links[i].missing;
  switch (links_[i].trouble) {
    case Trouble::kNone:
      return missing;
    case Trouble::kNoTransform:
      return "no transform from \"" + model_->frames[i] + "\" to \"" + model_->fixed_frame + "\"";
    case Trouble::kStale:
      return "stale: no transform accepted for longer than timeout";
    case Trouble::kPoseNotFinite:
      return "its pose in tf is not finite or too large";
  }
  return missing;
}

}  // namespace link_bounds

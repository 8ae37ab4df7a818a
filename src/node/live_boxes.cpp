// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds only the links on whose path a transform arrived, and anew only those that moved.
#include "live_boxes.h"

#include <utility>

namespace link_bounds {
namespace {

bool isSame(const std::optional<Aabb>& a, const std::optional<Aabb>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->min() == b->min() && a->max() == b->max();
}

}  // namespace

void LiveBoxes::adopt(std::shared_ptr<const Model> model, TransformSource& tf, ros::Time now) {
  model_ = std::move(model);
  troubles_.assign(model_->links.size(), Trouble::kNoTransform);
  states_.assign(model_->links.size(), BoxState());
  reaches_.clear();
  for (const BoundedLink& link : model_->links)
    reaches_.emplace_back(link);
  std::vector<FrameTree::Frame> frames;
  for (const std::string& name : model_->frames)
    frames.push_back(tf.tree().frame(name));
  poses_.follow(tf.tree().frame(model_->fixed_frame), std::move(frames));
  updateAll(tf, now);
}

bool LiveBoxes::updateAll(const TransformSource& tf, ros::Time now) {
  if (!model_) return false;
  poses_.updateAll(tf);
  return refreshNews(now);
}

bool LiveBoxes::update(const TransformSource& tf, ros::Time now) {
  if (!model_) return false;
  poses_.update(tf);
  return refreshNews(now);
}

bool LiveBoxes::refreshNews(ros::Time now) {
  bool is_changed = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (isNews(i)) is_changed |= canKeepBox(i, now) ? restamp(i) : refresh(i, now);
  }
  return is_changed;
}

bool LiveBoxes::expire(const TransformSource& tf, ros::Time now) {
  poses_.updateHeard(tf.tree());
  bool is_changed = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const PoseTree::Node* node = poses_.node(i);
    if (troubles_[i] != Trouble::kStale && node && isStale(*node, now)) {
      is_changed |= refresh(i, now);
    }
  }
  return is_changed;
}

bool LiveBoxes::isNews(std::size_t i) const {
  const PoseTree::Node* node = poses_.node(i);
  return node ? node->is_news : poses_.isRebuilt();
}

bool LiveBoxes::isStale(const PoseTree::Node& node, ros::Time now) const {
  const double timeout = model_->parameters.timeout;
  if (timeout <= 0 || node.heard == PoseTree::kNever) return false;
  return static_cast<double>(now.toNSec()) - static_cast<double>(node.heard) > timeout * 1e9;
}

/// True if nothing but the stamp can differ.
bool LiveBoxes::canKeepBox(std::size_t i, ros::Time now) const {
  const PoseTree::Node* node = poses_.node(i);
  return node && node->has_pose && !node->has_moved && states_[i].box &&
         troubles_[i] == Trouble::kNone && !isStale(*node, now);
}

bool LiveBoxes::restamp(std::size_t i) {
  const std::int64_t stamp = poses_.node(i)->stamp;
  return std::exchange(states_[i].stamp, stamp) != stamp;
}

bool LiveBoxes::refresh(std::size_t i, ros::Time now) {
  std::optional<Aabb> box;
  const Trouble trouble = place(i, now, box);
  const std::int64_t stamp = box ? poses_.node(i)->stamp : 0;
  BoxState& state = states_[i];
  const bool is_changed =
      trouble != troubles_[i] || stamp != state.stamp || !isSame(box, state.box);
  troubles_[i] = trouble;
  state.box = box;
  state.stamp = stamp;
  state.incomplete = trouble != Trouble::kNone || !model_->links[i].isWhole();
  return is_changed;
}

/// Leaves `box` empty where there is none.
LiveBoxes::Trouble LiveBoxes::place(std::size_t i, ros::Time now, std::optional<Aabb>& box) {
  const BoundedLink& link = model_->links[i];
  if (link.shapes.empty()) return Trouble::kNone;
  const PoseTree::Node* node = poses_.node(i);
  if (!node) return Trouble::kNoTransform;
  if (isStale(*node, now)) return Trouble::kStale;
  if (!node->has_pose) return Trouble::kNoTransform;
  box = linkBox(link, toAffine(node->fixed_from_frame), reaches_[i]);
  return box ? Trouble::kNone : Trouble::kPoseNotFinite;
}

std::string LiveBoxes::reason(std::size_t i) const {
  const std::string& missing = model_->links[i].missing;
  switch (troubles_[i]) {
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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds only the links on whose path a transform arrived, and anew only those that moved.
#include "live_boxes.h"

#include <utility>

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
  poses_.updateAll(tf);
  return refreshNews(now);
}

bool LiveBoxes::update(const TransformSource& tf, ros::Time now) {
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
  BoxState state;
  const Trouble trouble = place(i, now, state);
  state.incomplete = trouble != Trouble::kNone || !model_->links[i].isWhole();
  const bool is_changed = trouble != troubles_[i] || !isSame(state, states_[i]);
  troubles_[i] = trouble;
  states_[i] = state;
  return is_changed;
}

LiveBoxes::Trouble LiveBoxes::place(std::size_t i, ros::Time now, BoxState& state) {
  const BoundedLink& link = model_->links[i];
  if (link.shapes.empty()) return Trouble::kNone;
  const PoseTree::Node* node = poses_.node(i);
  if (!node) return Trouble::kNoTransform;
  if (isStale(*node, now)) return Trouble::kStale;
  if (!node->has_pose) return Trouble::kNoTransform;
  state.box = linkBox(link, toAffine(node->fixed_from_frame), reaches_[i]);
  if (!state.box) return Trouble::kPoseNotFinite;
  state.stamp = node->stamp;
  return Trouble::kNone;
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

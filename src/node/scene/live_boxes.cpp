// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds only the links on whose path a transform arrived, and anew only those that moved.
#include "node/scene/live_boxes.h"

#include <utility>

namespace link_bounds {

void LiveBoxes::adopt(std::shared_ptr<const Model> model, TransformSource& tf, ros::Time now) {
  model_ = std::move(model);
  troubles_.assign(model_->links.size(), Trouble::kNoTransform);
  states_.assign(model_->links.size(), BoxState());
  boxes_ = LinkBoxes(model_->links);
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
  const std::int64_t stale_before = staleBefore(model_->parameters.timeout, now);
  bool is_changed = false;
  for (std::size_t i = 0; i < states_.size(); ++i)
    is_changed |= refresh(i, stale_before);
  is_changed |= boundWaiting();
  return is_changed;
}

bool LiveBoxes::expire(const TransformSource& tf, ros::Time now) {
  if (!model_) return false;
  poses_.updateHeard(tf.tree());
  const std::int64_t stale_before = staleBefore(model_->parameters.timeout, now);
  bool is_changed = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const PoseTree::Node* node = poses_.node(i);
    const bool can_be_stale = troubles_[i] != Trouble::kStale && !model_->links[i].shapes.empty();
    if (can_be_stale && node && node->heard < stale_before) is_changed |= drop(i, Trouble::kStale);
  }
  return is_changed;
}

/// Where nothing but the stamp can differ, nothing else is looked at. A box that is to be computed
/// waits for the others. It is news even if it comes out the same: the pose is another one.
bool LiveBoxes::refresh(std::size_t i, std::int64_t stale_before) {
  const PoseTree::Node* node = poses_.node(i);
  if (!(node ? node->is_news : poses_.isRebuilt())) return false;
  if (model_->links[i].shapes.empty()) return drop(i, Trouble::kNone);
  if (!node) return drop(i, Trouble::kNoTransform);
  if (node->heard < stale_before) return drop(i, Trouble::kStale);
  if (!node->has_pose) return drop(i, Trouble::kNoTransform);
  BoxState& state = states_[i];
  if (!node->has_moved && state.box) return std::exchange(state.stamp, node->stamp) != node->stamp;
  waiting_.push_back({i, &node->fixed_from_frame.affine});
  return false;
}

bool LiveBoxes::boundWaiting() {
  boxes_.update(waiting_);
  bool is_changed = false;
  for (const auto& [i, world_from_link] : waiting_) {
    states_[i].box = boxes_.box(i);
    const Trouble trouble = states_[i].box ? Trouble::kNone : Trouble::kPoseNotFinite;
    is_changed |= states_[i].box || trouble != troubles_[i];
    describe(i, trouble);
  }
  waiting_.clear();
  return is_changed;
}

/// A link without a box; true if it had one, or had none for another reason.
bool LiveBoxes::drop(std::size_t i, Trouble trouble) {
  const bool is_changed = states_[i].box || trouble != troubles_[i];
  states_[i].box.reset();
  describe(i, trouble);
  return is_changed;
}

/// All of the state but the box.
void LiveBoxes::describe(std::size_t i, Trouble trouble) {
  troubles_[i] = trouble;
  states_[i].stamp = states_[i].box ? poses_.node(i)->stamp : 0;
  states_[i].incomplete = trouble != Trouble::kNone || !model_->links[i].isWhole();
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

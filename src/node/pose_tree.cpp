// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The tree is built when tf's structure changes, and read from the inside out.
#include "pose_tree.h"

#include <algorithm>

namespace link_bounds {
namespace {

/// Of two times, 0 stands for always.
std::int64_t earlier(std::int64_t a, std::int64_t b) {
  return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
}

}  // namespace

void PoseTree::follow(Frame fixed_frame, std::vector<Frame> frames) {
  fixed_frame_ = fixed_frame;
  frames_ = std::move(frames);
  places_.assign(frames_.size(), kNowhere);
  nodes_.clear();
}

void PoseTree::update(const TransformSource& tf) {
  if (structure_ != tf.tree().structure()) return updateAll(tf);
  is_rebuilt_ = false;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    node.has_moved = false;
    node.is_news = nodes_[node.inner].is_news || tf.tree().isNews(node.edge) || node.was_elsewhere;
    if (node.is_news) place(node, tf);
  }
}

void PoseTree::updateAll(const TransformSource& tf) {
  structure_ = tf.tree().structure();
  is_rebuilt_ = true;
  marks_.begin(tf.tree().size());
  nodes_.assign(1, Node());
  nodes_.front().is_news = false;
  nodes_.front().has_pose = true;
  marks_.set(fixed_frame_, 0);
  for (std::size_t i = 0; i < frames_.size(); ++i)
    places_[i] = addPath(frames_[i], tf.tree());
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    place(nodes_[i], tf);
}

void PoseTree::updateHeard(const FrameTree& tree) {
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    hear(nodes_[i], tree);
}

/// The place of the frame's node. The path climbs from the frame, then from the fixed frame.
std::size_t PoseTree::addPath(Frame frame, const FrameTree& tree) {
  if (frame == fixed_frame_) return append(0, frame, frame, Node::Step::kStay);
  const std::optional<std::vector<Frame>> path = tree.path(frame, fixed_frame_);
  if (!path) return kNowhere;
  std::size_t turn = 0;
  for (Frame top = frame; turn < path->size() && (*path)[turn] == top; ++turn)
    top = tree.parent(top);
  std::size_t place = 0;
  for (std::size_t i = turn; i < path->size(); ++i)
    place = add(place, tree.parent((*path)[i]), (*path)[i], Node::Step::kAgainst);
  for (std::size_t i = turn; i-- > 0;)
    place = add(place, (*path)[i], (*path)[i], Node::Step::kAlong);
  return place;
}

std::size_t PoseTree::add(std::size_t inner, Frame frame, Frame edge, Node::Step step) {
  if (const std::optional<std::size_t> place = marks_.position(frame)) return *place;
  marks_.set(frame, nodes_.size());
  return append(inner, frame, edge, step);
}

std::size_t PoseTree::append(std::size_t inner, Frame frame, Frame edge, Node::Step step) {
  Node node;
  node.frame = frame;
  node.edge = edge;
  node.step = step;
  node.inner = inner;
  nodes_.push_back(node);
  return nodes_.size() - 1;
}

/// The pose before this one serves if it is of the same time, or of all times; the edge does if it
/// had the same parent then. The fixed frame in itself has the stamp of its own edge, as in tf2.
void PoseTree::place(Node& node, const TransformSource& tf) const {
  const FrameTree& tree = tf.tree();
  const Node& inner = nodes_[node.inner];
  hear(node, tree);
  node.stamp = earlier(inner.stamp, tree.newest(node.edge));
  node.is_static = inner.is_static && tree.isStatic(node.edge);
  if (node.step == Node::Step::kStay) {
    node.has_pose = true;
    return;
  }
  const bool inner_serves = inner.has_pose && (inner.is_static || inner.stamp == node.stamp);
  node.was_elsewhere = false;
  EdgeSample scratch;
  const EdgeSample* edge =
      inner_serves ? tf.histories().at(node.edge, node.stamp, scratch) : nullptr;
  if (!edge || edge->parent != tree.parent(node.edge)) {
    walk(node, tf);
  } else if (node.step == Node::Step::kAlong) {
    compose(node, edge->parent_from_child);
  } else {
    compose(node, inverse(edge->parent_from_child));
  }
}

void PoseTree::compose(Node& node, const Tf2Pose& inner_from_frame) const {
  const MatrixPose& fixed_from_inner = nodes_[node.inner].fixed_from_frame;
  const bool is_other = node.fixed_from_frame.setProduct(fixed_from_inner, inner_from_frame);
  node.has_moved = is_other || !node.has_pose;
  node.has_pose = true;
}

/// At that time the path may have been another one, whose edges bring news as well.
void PoseTree::walk(Node& node, const TransformSource& tf) const {
  const std::optional<Tf2Pose> pose = tf.histories().pose(fixed_frame_, node.frame, node.stamp);
  node.has_moved = true;
  node.has_pose = pose.has_value();
  node.was_elsewhere = true;
  if (pose) node.fixed_from_frame = MatrixPose(*pose);
}

void PoseTree::hear(Node& node, const FrameTree& tree) const {
  if (node.step == Node::Step::kStay) return;
  node.heard = nodes_[node.inner].heard;
  if (!tree.isStatic(node.edge)) node.heard = std::min(node.heard, tree.lastHeard(node.edge));
}

}  // namespace link_bounds

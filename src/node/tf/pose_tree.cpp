// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The tree is built when tf's structure changes, and read from the inside out.
#include "node/tf/pose_tree.h"

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

/// A frame that is where it was has not moved.
void PoseTree::updateAll(const TransformSource& tf) {
  structure_ = tf.tree().structure();
  is_rebuilt_ = true;
  const std::vector<Node> old_nodes = std::move(nodes_);
  const std::vector<std::size_t> old_places = places_;
  build(tf.tree());
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    place(nodes_[i], tf);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (places_[i] == kNowhere || old_places[i] == kNowhere) continue;
    const MatrixPose& old = old_nodes[old_places[i]].fixed_from_frame;
    Node& node = nodes_[places_[i]];
    node.has_moved = !old_nodes[old_places[i]].has_pose ||
                     !node.fixed_from_frame.isAt(old.rotation, old.translation());
  }
}

void PoseTree::updateHeard(const FrameTree& tree) {
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    hear(nodes_[i], tree);
}

void PoseTree::build(const FrameTree& tree) {
  nodes_.assign(1, Node());
  nodes_.front().is_news = false;
  nodes_.front().has_pose = true;
  findAbove(tree);
  marks_.begin(tree.size());
  marks_.set(fixed_frame_, 0);
  for (std::size_t i = 0; i < frames_.size(); ++i)
    places_[i] = addPath(frames_[i], tree);
}

/// If the way up from the fixed frame runs into a loop, a frame must meet the fixed frame itself.
void PoseTree::findAbove(const FrameTree& tree) {
  above_.assign(1, fixed_frame_);
  heights_.begin(tree.size());
  heights_.set(fixed_frame_, 0);
  while (tree.hasParent(above_.back())) {
    const Frame parent = tree.parent(above_.back());
    if (heights_.position(parent)) {
      above_.resize(1);
      heights_.begin(tree.size());
      heights_.set(fixed_frame_, 0);
      break;
    }
    heights_.set(parent, above_.size());
    above_.push_back(parent);
  }
  above_from_fixed_.assign(above_.size(), Tf2Pose());
}

/// The place of the frame's node, or kNowhere. Climbs to a frame whose node is there or that is
/// above the fixed one; each frame is climbed once, so that deep trees cost as much as flat ones.
std::size_t PoseTree::addPath(Frame frame, const FrameTree& tree) {
  if (frame == fixed_frame_) return append(0, frame, frame, Node::Step::kStay);
  way_.clear();
  Frame top = frame;
  while (!marks_.position(top) && !heights_.position(top)) {
    marks_.set(top, kNowhere);
    if (!tree.hasParent(top)) return kNowhere;
    way_.push_back(top);
    top = tree.parent(top);
  }
  const auto known = marks_.position(top);
  std::size_t place = known ? *known : addAbove(*heights_.position(top));
  for (std::size_t i = way_.size(); i-- > 0 && place != kNowhere;) {
    place = append(place, way_[i], way_[i], Node::Step::kAlong);
    marks_.set(way_[i], place);
  }
  return place;
}

/// The same of a frame above the fixed one.
std::size_t PoseTree::addAbove(std::size_t height) {
  std::size_t below = height;
  while (!marks_.position(above_[below]))
    --below;
  std::size_t place = *marks_.position(above_[below]);
  for (; below < height; ++below) {
    place = append(place, above_[below + 1], above_[below], Node::Step::kAgainst);
    marks_.set(above_[below + 1], place);
  }
  return place;
}

std::size_t PoseTree::append(std::size_t inner, Frame frame, Frame edge, Node::Step step) {
  Node node;
  node.frame = frame;
  node.edge = edge;
  node.step = step;
  node.is_below = step != Node::Step::kAgainst && nodes_[inner].is_below;
  node.inner = inner;
  nodes_.push_back(node);
  return nodes_.size() - 1;
}

/// The fixed frame in itself has the stamp of its own edge, as in tf2.
void PoseTree::place(Node& node, const TransformSource& tf) {
  const FrameTree& tree = tf.tree();
  const Node& inner = nodes_[node.inner];
  const bool had_pose = node.has_pose;
  hear(node, tree);
  node.stamp = earlier(inner.stamp, tree.newest(node.edge));
  node.is_static = inner.is_static && tree.isStatic(node.edge);
  node.has_pose = true;
  if (node.step == Node::Step::kStay) return;
  node.was_elsewhere = false;
  node.has_moved = compose(node, tf) || !had_pose;
}

/// The pose before this one serves if it is of the same time, or of all times; the edge does if it
/// had the same parent then; and above the path must not have been a loop. True if the pose is
/// another one than before.
bool PoseTree::compose(Node& node, const TransformSource& tf) {
  const Node& inner = nodes_[node.inner];
  const bool inner_serves = inner.has_pose && (inner.is_static || inner.stamp == node.stamp);
  const bool is_above_as_now = node.is_below || node.is_static || node.stamp >= tf.tree().settled();
  if (!inner_serves || !is_above_as_now) return walk(node, tf);
  EdgeSample scratch;
  const EdgeSample* edge = tf.histories().at(node.edge, node.stamp, scratch);
  if (!edge || edge->parent != tf.tree().parent(node.edge)) return walk(node, tf);
  if (node.step == Node::Step::kAgainst) {
    return inner.was_elsewhere ? walk(node, tf) : invert(node, *edge);
  }
  return node.fixed_from_frame.setProduct(inner.fixed_from_frame, edge->parent_from_child);
}

/// tf2 inverts the whole way up at once, which counts if a quaternion is not of length 1.
bool PoseTree::invert(Node& node, const EdgeSample& edge) {
  const std::size_t height = *heights_.position(node.frame);
  Tf2Pose& frame_from_fixed = above_from_fixed_[height];
  frame_from_fixed = edge.parent_from_child * above_from_fixed_[height - 1];
  const Tf2Pose fixed_from_frame = inverse(frame_from_fixed);
  return node.fixed_from_frame.change(fixed_from_frame.rotation(), fixed_from_frame.translation());
}

/// At that time the path may have been another one, whose edges bring news as well.
bool PoseTree::walk(Node& node, const TransformSource& tf) const {
  const std::optional<Tf2Pose> pose = tf.histories().pose(fixed_frame_, node.frame, node.stamp);
  node.has_pose = pose.has_value();
  node.was_elsewhere = true;
  return pose && node.fixed_from_frame.change(pose->rotation(), pose->translation());
}

void PoseTree::hear(Node& node, const FrameTree& tree) const {
  if (node.step == Node::Step::kStay) return;
  node.heard = nodes_[node.inner].heard;
  if (!tree.isStatic(node.edge)) node.heard = std::min(node.heard, tree.lastHeard(node.edge));
}

}  // namespace link_bounds

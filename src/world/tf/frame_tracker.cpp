// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The tree is built when tf's structure changes. Poses are computed from the fixed frame outward.
#include "world/tf/frame_tracker.h"

#include <algorithm>

namespace link_bounds {

std::int64_t olderStamp(std::int64_t a, std::int64_t b) {
  return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
}

std::int64_t staleBefore(double timeout, ros::Time now) {
  constexpr std::int64_t kBeforeAllTimes = std::numeric_limits<std::int64_t>::min();
  const double before = static_cast<double>(now.toNSec()) - timeout * 1e9;
  const bool is_never = timeout <= 0 || before <= static_cast<double>(kBeforeAllTimes);
  return is_never ? kBeforeAllTimes : static_cast<std::int64_t>(before);
}

FrameTracker::Node FrameTracker::rootNode() {
  Node node;
  node.has_pose = true;
  return node;
}

void FrameTracker::setTarget(Frame fixed_frame, double timeout, ros::Time now) {
  fixed_frame_ = fixed_frame;
  timeout_ = timeout;
  updateAll(now);
}

FrameTracker::Handle FrameTracker::follow(Frame frame) {
  if (frame >= followed_.size()) followed_.resize(frame + 1);
  Followed& followed = followed_[frame];
  const std::size_t old_size = nodes_.size();
  if (followed.handles++ == 0) {
    if (followed.place == kNowhere) {
      followed.place = add(frame);
    } else {
      --unused_;
    }
  }
  for (std::size_t i = old_size; i < nodes_.size(); ++i)
    place(nodes_[i]);
  return {*this, frame};
}

void FrameTracker::release(Frame frame) {
  if (--followed_[frame].handles == 0) ++unused_;
}

/// Undoes the need() calls of append().
void FrameTracker::release(const std::vector<Node>& nodes) {
  for (const Node& node : nodes) {
    if (isMade(node.step)) tf_.release(node.edge);
  }
}

/// Frames that nobody follows any more are removed in the next build: to remove each one at once
/// would take a build per frame.
void FrameTracker::update(ros::Time now) {
  if (structure_ != tf_.structure() || unused_ > nodes_.size() / 2) return updateAll(now);
  stale_before_ = staleBefore(timeout_, now);
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    node.is_changed = node.has_moved = false;
    node.is_news =
        nodes_[node.inner].is_news || tf_.isNewerThan(seen_, node.edge) || node.was_elsewhere;
    if (node.is_news) place(node);
  }
  seen_ = tf_.version();
}

/// A frame has moved if its pose after the build differs from that before.
void FrameTracker::updateAll(ros::Time now) {
  stale_before_ = staleBefore(timeout_, now);
  const std::vector<Node> old_nodes = std::move(nodes_);
  const std::vector<Place> places = takePlaces(old_nodes);
  build(places);
  release(old_nodes);
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    place(nodes_[i]);
  seen_ = tf_.version();
  for (const auto& [frame, old_place] : places) {
    const Node& old = old_nodes[old_place];
    Node& node = nodes_[followed_[frame].place];
    node.has_moved =
        !old.has_pose || !node.fixed_from_frame.isAt(old.fixed_from_frame.rotation,
                                                     old.fixed_from_frame.translation());
    node.setChanged(old.problem, old.stamp);
  }
}

void FrameTracker::watch(Frame frame) {
  tf_.watch(frame);
  watched_.push_back(frame);
}

/// As update(), removes frames that nobody follows any more: without messages nobody calls
/// update().
void FrameTracker::expire(ros::Time now) {
  if (unused_ > nodes_.size() / 2) return updateAll(now);
  for (const Frame frame : watched_)
    tf_.watch(frame);
  stale_before_ = staleBefore(timeout_, now);
  for (Node& node : nodes_) {
    node.has_moved = false;
    node.is_changed = node.problem != TransformProblem::kStale && node.received < stale_before_;
    if (node.is_changed) node.problem = TransformProblem::kStale;
  }
}

/// Returns the places of followed frames and clears all places. Iterates over the nodes only,
/// because tf may have any number of frames.
std::vector<FrameTracker::Place> FrameTracker::takePlaces(const std::vector<Node>& nodes) {
  std::vector<Place> places;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Frame frame = nodes[i].frame;
    if (frame >= followed_.size() || followed_[frame].place != i) continue;
    if (followed_[frame].handles > 0) places.push_back({frame, i});
    followed_[frame].place = kNowhere;
  }
  return places;
}

void FrameTracker::build(const std::vector<Place>& places) {
  structure_ = tf_.structure();
  nodes_.assign(1, rootNode());
  watched_.clear();
  unused_ = 0;
  if (fixed_frame_) {
    findAbove();
    marks_.begin(tf_.size());
    marks_.set(*fixed_frame_, 0);
  }
  for (const Place& followed : places)
    followed_[followed.frame].place = add(followed.frame);
}

/// If the way up from the fixed frame runs into a loop, only the fixed frame itself counts as
/// above.
void FrameTracker::findAbove() {
  above_.assign(1, *fixed_frame_);
  heights_.begin(tf_.size());
  heights_.set(*fixed_frame_, 0);
  watch(*fixed_frame_);
  while (tf_.hasParent(above_.back())) {
    const Frame parent = tf_.parent(above_.back());
    watch(parent);
    if (heights_.position(parent)) {
      above_.resize(1);
      heights_.begin(tf_.size());
      heights_.set(*fixed_frame_, 0);
      break;
    }
    heights_.set(parent, above_.size());
    above_.push_back(parent);
  }
  above_from_fixed_.assign(above_.size(), Tf2Pose());
}

/// The place of a node for a followed frame. The node has no pose if no path is known.
std::size_t FrameTracker::add(Frame frame) {
  const bool is_current = fixed_frame_ && structure_ == tf_.structure();
  const std::size_t place = is_current ? addPath(frame) : kNowhere;
  return place == kNowhere ? append(0, frame, frame, Step::kNone) : place;
}

/// The place of the frame's node, or kNowhere. Climbs to a frame that has a node or is above the
/// fixed frame. Climbs from each frame only once, so that deep trees cost as much as flat ones.
std::size_t FrameTracker::addPath(Frame frame) {
  if (frame == *fixed_frame_) return append(0, frame, frame, Step::kStay);
  marks_.grow(tf_.size());
  heights_.grow(tf_.size());
  way_.clear();
  Frame top = frame;
  while (!marks_.position(top) && !heights_.position(top)) {
    marks_.set(top, kNowhere);
    watch(top);
    if (!tf_.hasParent(top)) return kNowhere;
    way_.push_back(top);
    top = tf_.parent(top);
  }
  const auto known = marks_.position(top);
  std::size_t place = known ? *known : addAbove(*heights_.position(top));
  for (std::size_t i = way_.size(); i-- > 0 && place != kNowhere;) {
    place = append(place, way_[i], way_[i], Step::kAlong);
    marks_.set(way_[i], place);
  }
  return place;
}

/// The place of the node of above_[height]. Adds the nodes from the fixed frame up to it.
std::size_t FrameTracker::addAbove(std::size_t height) {
  std::size_t below = height;
  while (!marks_.position(above_[below]))
    --below;
  std::size_t place = *marks_.position(above_[below]);
  for (; below < height; ++below) {
    place = append(place, above_[below + 1], above_[below], Step::kAgainst);
    marks_.set(above_[below + 1], place);
  }
  return place;
}

std::size_t FrameTracker::append(std::size_t inner, Frame frame, Frame edge, Step step) {
  Node node;
  node.frame = frame;
  node.edge = edge;
  node.step = step;
  node.is_below = step != Step::kAgainst && nodes_[inner].is_below;
  node.inner = inner;
  if (isMade(step)) tf_.need(edge);
  nodes_.push_back(node);
  return nodes_.size() - 1;
}

/// Computes pose, stamp and problem of a node. If the fixed frame itself is followed, its stamp is
/// that of the edge to its parent, as in tf2.
void FrameTracker::place(Node& node) {
  if (node.step == Step::kNone) return;
  const Node& inner = nodes_[node.inner];
  const bool had_pose = node.has_pose;
  const TransformProblem old_problem = node.problem;
  const std::int64_t old_stamp = node.stamp;
  setReceived(node);
  node.stamp = olderStamp(inner.stamp, tf_.newest(node.edge));
  node.is_static = inner.is_static && tf_.isStatic(node.edge);
  node.has_pose = true;
  node.was_elsewhere = false;
  if (node.step != Step::kStay) node.has_moved = compose(node) || !had_pose;
  node.problem = node.received < stale_before_ ? TransformProblem::kStale
                 : node.has_pose               ? TransformProblem::kNone
                                               : TransformProblem::kNoTransform;
  node.setChanged(old_problem, old_stamp);
}

/// Uses the inner pose if it has the same stamp or a static path, and the edge if its parent at
/// that stamp was the current one. A path that leads above the fixed frame must also be unchanged
/// since then: tf2 gives no pose if a loop was above. Otherwise calls walk(). True if the pose
/// changed.
bool FrameTracker::compose(Node& node) {
  const Node& inner = nodes_[node.inner];
  const bool inner_serves = inner.has_pose && (inner.is_static || inner.stamp == node.stamp);
  const bool is_above_as_now = node.is_below || node.is_static || node.stamp >= tf_.settled();
  if (!inner_serves || !is_above_as_now) return walk(node);
  EdgeSample scratch;
  const EdgeSample* edge = tf_.at(node.edge, node.stamp, scratch);
  if (!edge || edge->parent != tf_.parent(node.edge)) return walk(node);
  if (node.step == Step::kAgainst) return inner.was_elsewhere ? walk(node) : invert(node, *edge);
  return node.fixed_from_frame.setProduct(inner.fixed_from_frame, edge->parent_from_child);
}

/// As tf2, inverts the complete way up at once. If a quaternion is not of length 1, inverting edge
/// by edge would give another pose.
bool FrameTracker::invert(Node& node, const EdgeSample& edge) {
  const std::size_t height = *heights_.position(node.frame);
  Tf2Pose& frame_from_fixed = above_from_fixed_[height];
  frame_from_fixed = edge.parent_from_child * above_from_fixed_[height - 1];
  const Tf2Pose fixed_from_frame = inverse(frame_from_fixed);
  return node.fixed_from_frame.change(fixed_from_frame.rotation(), fixed_from_frame.translation());
}

/// Reads the complete path as it was at the stamp. Its edges may be other ones than now, whose news
/// is_news misses. So was_elsewhere makes update() read the path again each time.
bool FrameTracker::walk(Node& node) const {
  const std::optional<Tf2Pose> pose = tf_.pose(*fixed_frame_, node.frame, node.stamp);
  node.has_pose = pose.has_value();
  node.was_elsewhere = true;
  return pose && node.fixed_from_frame.change(pose->rotation(), pose->translation());
}

void FrameTracker::setReceived(Node& node) const {
  if (node.step == Step::kStay) return;
  node.received = nodes_[node.inner].received;
  if (!tf_.isStatic(node.edge)) node.received = std::min(node.received, tf_.received(node.edge));
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds transforms to the table, and reads poses along its edges.
#include "node/tf/transform_buffer.h"

#include <algorithm>

#include "node/tf/transform_refusal.h"

namespace link_bounds {
namespace {

constexpr std::int64_t kSilence = 1000000000;  // ns without a good transform that deserve a warning
constexpr const char* kOwnParent = "the frame is its own parent; correct one of the names";
constexpr const char* kTooOld =
    "its stamp is more than 10 s older than the newest one of the frame; synchronise the clocks; "
    "if that newest one is wrong, ~reload makes the node forget it";

std::int64_t nanoseconds(ros::Time time) {
  return static_cast<std::int64_t>(time.toNSec());
}

}  // namespace

TransformBuffer::Frame TransformBuffer::frame(std::string_view name) {
  const Frame frame = names_.frame(name);
  edges_.resize(names_.size());
  return frame;
}

std::vector<Refusal> TransformBuffer::add(const std::vector<TransformView>& transforms,
                                          bool is_static, ros::Time now) {
  std::vector<Refusal> refusals;
  ++message_;
  names_.beginMessage();
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const char* reason = whyRefused(transforms[i]);
    if (reason) ++intake_.unusable;
    if (!reason) reason = insert(transforms[i], is_static, nanoseconds(now));
    if (reason) refusals.push_back({i, reason});
  }
  return refusals;
}

/// Returns why it was refused, if that is to be reported.
const char* TransformBuffer::insert(const TransformView& transform, bool is_static,
                                    std::int64_t now) {
  const auto [child, parent] = names_.next(transform.parent, transform.child, transform.names);
  if (names_.size() > edges_.size()) edges_.resize(names_.size());
  if (child == parent) {
    ++intake_.unusable;
    return kOwnParent;
  }
  Edge& edge = edges_[child];
  if (!edge.history) edge.history.emplace(edge.is_static = is_static);
  const std::int64_t stamp = nanoseconds(transform.stamp);
  if (!edge.history->insert(stamp, parent, transform.parent_from_child)) {
    if (!edge.is_distrusted || !isTooOld(child, stamp)) return refuse(child, stamp, now);
    edge.clear();
    edge.history->insert(stamp, parent, transform.parent_from_child);
  }
  ++intake_.accepted;
  record(edge, parent, stamp);
  edge.received = now;
  edge.message = message_;
  edge.is_distrusted = false;
  return nullptr;
}

/// Parent and stamp of a transform that was accepted. A late one leaves the newest in place.
void TransformBuffer::record(Edge& edge, Frame parent, std::int64_t stamp) {
  const bool is_new = !edge.has_parent;
  const bool is_other = !is_new && edge.parent != parent;
  if (is_new || is_other) {
    ++structure_;
    edge.is_met = edges_[parent].is_met = true;
  }
  if (is_other) settled_ = std::max({settled_, stamp, edge.newest});
  if (stamp < edge.newest) {
    ++intake_.late;
    return;
  }
  edge.newest = edge.is_static ? 0 : stamp;
  edge.parent = parent;
  edge.has_parent = true;
}

/// Static edges stay.
void TransformBuffer::Edge::clear() {
  if (!history || is_static) return;
  history->clear();
  newest = 0;
  has_parent = false;
}

/// Otherwise there is one of that stamp.
bool TransformBuffer::isTooOld(Frame child, std::int64_t stamp) const {
  return stamp + EdgeHistory::kLength < newest(child);
}

const char* TransformBuffer::refuse(Frame child, std::int64_t stamp, std::int64_t now) {
  if (!isTooOld(child, stamp)) {
    ++intake_.repeated;
    return nullptr;
  }
  ++intake_.too_old;
  return now - received(child) > kSilence ? kTooOld : nullptr;
}

/// Climbs from the source as far as it can, then from the target until it meets that way.
std::optional<Tf2Pose> TransformBuffer::pose(Frame target, Frame source, std::int64_t stamp) const {
  if (source == target) return Tf2Pose();
  if (!climb(source, target, stamp)) return std::nullopt;
  Tf2Pose frame_from_target;
  Frame frame = target;
  EdgeSample scratch;
  for (std::size_t steps = 0; !marks_.position(frame); ++steps) {
    const EdgeSample* edge = at(frame, stamp, scratch);
    if (steps > edges_.size() || !edge) return std::nullopt;
    frame_from_target = edge->parent_from_child * frame_from_target;
    frame = edge->parent;
  }
  const Tf2Pose& frame_from_source = steps_[*marks_.position(frame)].frame_from_source;
  if (frame == target) return frame_from_source;
  return inverse(frame_from_target) * frame_from_source;
}

/// Ends at the target or where a history ends; false if a loop closes.
bool TransformBuffer::climb(Frame source, Frame target, std::int64_t stamp) const {
  marks_.begin(edges_.size());
  steps_.assign(1, {source, Tf2Pose()});
  marks_.set(source, 0);
  EdgeSample scratch;
  while (steps_.back().frame != target) {
    const EdgeSample* edge = at(steps_.back().frame, stamp, scratch);
    if (!edge) return true;
    if (marks_.position(edge->parent)) return false;
    marks_.set(edge->parent, steps_.size());
    steps_.push_back({edge->parent, edge->parent_from_child * steps_.back().frame_from_source});
  }
  return true;
}

void TransformBuffer::clear() {
  for (Edge& edge : edges_)
    edge.clear();
  ++message_;
  ++structure_;
  ++epoch_;
}

void TransformBuffer::distrustStampsAhead(ros::Time now) {
  for (Frame child = 0; child < edges_.size(); ++child)
    edges_[child].is_distrusted = newest(child) > nanoseconds(now) + EdgeHistory::kLength;
}

void TransformBuffer::startClock(ros::Time now) {
  for (Edge& edge : edges_) {
    if (edge.received == 0) edge.received = nanoseconds(now);
  }
}

}  // namespace link_bounds

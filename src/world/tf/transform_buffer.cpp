// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds transforms to the table, and reads poses along its edges.
#include "world/tf/transform_buffer.h"

#include <algorithm>
#include <cstdlib>

#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

/// A frame that nobody needs is forgotten after this time without a transform.
const ros::WallDuration kQuiet(60);
constexpr std::size_t kSlice = 1000;  // edges and samples per forgetQuiet(): about 50 us

/// A late transform gives no warning if it is behind by max this time, and the newest stamp of its
/// frame came within this time [ns].
constexpr std::int64_t kTolerance = 1000000000;

constexpr std::int64_t kAtClock = 500000000;  // ns that a stamp may differ from the clock
constexpr const char* kOwnParent = "the frame is its own parent; correct one of the names";
constexpr const char* kTooOld =
    "its stamp is more than 10 s older than the newest one of the frame; synchronise the clocks; "
    "if that newest one is wrong, ~reload makes the node forget it";
/// How long a static edge stays in doubt after the last contradiction [ns].
constexpr std::int64_t kDoubt = 10'000'000'000;
constexpr const char* kInDoubt =
    "it is on /tf_static, too, with another pose, so nobody knows how it moves; end one of the "
    "publishers";
constexpr const char* kLate =
    "its stamp is older than the newest one of the frame, so it does not move the frame; "
    "synchronise the clocks";

}  // namespace

TransformBuffer::Frame TransformBuffer::frame(std::string_view name) {
  const Frame frame = names_.frame(name);
  edges_.resize(names_.size());
  adoptNumber(frame);
  ++edges_[frame].holds;
  return frame;
}

/// To be called for each frame number that FrameNames returns: a forgotten number may have a new
/// name.
void TransformBuffer::adoptNumber(Frame frame) {
  if (!edges_[frame].is_unused) return;
  edges_[frame].is_unused = false;
  --unused_;
}

void TransformBuffer::count(std::uint64_t TfIntake::*what, bool is_needed) {
  ++(intake_.*what);
  if (is_needed) ++(needed_intake_.*what);
}

void TransformBuffer::countByName(std::uint64_t TfIntake::*what, std::string_view child) {
  const std::optional<Frame> frame = find(child);
  count(what, frame && edges_[*frame].isNeeded());
}

void TransformBuffer::countDropped(const TransformView& transform) {
  countByName(&TfIntake::dropped, transform.child);
}

std::vector<Refusal> TransformBuffer::add(const std::vector<TransformView>& transforms,
                                          bool is_static, ros::Time now) {
  std::vector<Refusal> refusals;
  ++message_;
  names_.beginMessage();
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    Refusal refusal{i, whyRefused(transforms[i])};
    if (refusal.reason) countByName(&TfIntake::unusable, transforms[i].child);
    if (refusal.reason || !insert(transforms[i], is_static, nanosecondsOf(now), refusal))
      refusals.push_back(refusal);
  }
  return refusals;
}

/// False if the transform is to be reported: `refusal` then says why.
bool TransformBuffer::insert(const TransformView& transform, bool is_static, std::int64_t now,
                             Refusal& refusal) {
  const auto [child, parent] = names_.next(transform.parent, transform.child, transform.names);
  if (names_.size() > edges_.size()) edges_.resize(names_.size());
  if (unused_ > 0) {
    adoptNumber(child);
    adoptNumber(parent);
  }
  if (child == parent) {
    count(&TfIntake::unusable, edges_[child].isNeeded());
    refusal.reason = kOwnParent;
    return false;
  }
  Edge& edge = edges_[child];
  if (!edge.has_parent || edge.parent != parent) {
    edges_[parent].referenced = pass_;
    edge.had_others |= edge.has_parent;
  }
  if (!edge.history) edge.history.emplace(edge.is_static = is_static);
  const std::int64_t stamp = nanosecondsOf(transform.stamp);
  const bool is_replaced = edge.is_static && edge.has_parent &&
                           !edge.history->holds({transform.parent_from_child, parent, stamp});
  if (is_replaced) count(&TfIntake::replaced, edge.isNeeded());
  edge.doubt(is_replaced, is_static, now);
  const bool is_accepted = insert(edge, stamp, parent, transform.parent_from_child);
  const bool is_in_order = is_accepted ? record(edge, parent, stamp, now)
                                       : refuse(edge, {transform.parent_from_child, parent, stamp});
  if (edge.is_in_doubt && !is_static) {
    refusal.reason = kInDoubt;
    refusal.is_accepted = true;
    return false;
  }
  if (is_in_order) return true;
  if (now - edge.received <= kTolerance && edge.newest - stamp <= kTolerance) return true;
  refusal.reason = is_accepted ? kLate : kTooOld;
  refusal.is_accepted = is_accepted;
  refusal.behind = static_cast<double>(edge.newest - stamp) / 1e9;
  return false;
}

/// A static edge that /tf contradicts is in doubt until /tf_static sends it more than kDoubt after
/// the last contradiction.
void TransformBuffer::Edge::doubt(bool is_replaced, bool on_static, std::int64_t now) {
  if (is_replaced && !on_static) {
    is_in_doubt = true;
    doubted = now;
  } else if (on_static && std::abs(now - doubted) > kDoubt) {
    is_in_doubt = false;
  }
}

/// False if the transform is refused.
bool TransformBuffer::insert(Edge& edge, std::int64_t stamp, Frame parent, const Tf2Pose& pose) {
  if (edge.history->insert(stamp, parent, pose)) return true;
  if (!edge.is_distrusted || !edge.isTooOld(stamp)) return false;
  edge.clear();
  return edge.history->insert(stamp, parent, pose);
}

/// Stores parent and stamp of an accepted transform. False for a late one, which changes neither
/// the newest stamp nor the time when that was received.
bool TransformBuffer::record(Edge& edge, Frame parent, std::int64_t stamp, std::int64_t now) {
  ++intake_.accepted;
  edge.message = message_;
  edge.is_distrusted = edge.was_needed = false;
  const bool is_new = !edge.has_parent;
  const bool is_other = !is_new && edge.parent != parent;
  if (is_new || is_other) {
    if (edge.watched > 0) ++structure_;
    edge.is_met = edges_[parent].is_met = true;
  }
  if (is_other) settled_ = std::max({settled_, stamp, edge.newest});
  if (stamp < edge.newest) {
    count(&TfIntake::late, edge.isNeeded());
    return false;
  }
  edge.newest = edge.is_static ? 0 : stamp;
  if (!edge.is_static && edge.needs > 0) max_lag_ = std::max(now - stamp, max_lag_.value_or(0));
  edge.received = now;
  edge.parent = parent;
  edge.has_parent = true;
  return true;
}

/// Forgets the transforms, unless the edge is static.
void TransformBuffer::Edge::clear() {
  is_in_doubt = false;
  if (!history || is_static) return;
  history->clear();
  was_needed = isNeeded();
  newest = 0;
  has_parent = false;
}

/// Counts a refused transform. True if it repeats a stamp; false if it is too old.
bool TransformBuffer::refuse(const Edge& edge, const EdgeSample& sample) {
  const bool is_repeated = !edge.isTooOld(sample.stamp);
  count(is_repeated ? &TfIntake::repeated : &TfIntake::too_old, edge.isNeeded());
  if (is_repeated && !edge.history->holds(sample)) count(&TfIntake::other, edge.isNeeded());
  return is_repeated;
}

/// Climbs from the source as far as possible, then from the target until it meets the first path.
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

/// Climbs to the target, or to the first frame without a transform at `stamp`. False in a loop.
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
  for (Edge& edge : edges_) {
    edge.is_distrusted = edge.newest > nanosecondsOf(now) + EdgeHistory::kLength;
    edge.is_in_doubt = false;
  }
}

void TransformBuffer::startClock(ros::Time now) {
  for (Edge& edge : edges_) {
    if (edge.received == 0) edge.received = nanosecondsOf(now);
  }
}

bool TransformBuffer::jumpAhead(ros::Time now) {
  bool is_any = false;
  for (Edge& edge : edges_) {
    if (std::abs(edge.newest - nanosecondsOf(now)) > kAtClock) continue;
    if (!is_any) ++message_;
    is_any = true;
    edge.message = message_;
    edge.received = nanosecondsOf(now);
  }
  return is_any;
}

/// Works in passes over all frames. A quiet frame that nobody needs loses its edge. If no edge
/// leads to it for another pass, it loses its name. Its number is reused after all readers on other
/// threads that may know it have ended. Static edges are always quiet, but a marker that is placed
/// once or the next request may need them: the first `kept` stay.
void TransformBuffer::forgetQuiet(ros::SteadyTime now, std::size_t kept) {
  if (noted_at_.isZero() || now - noted_at_ >= kQuiet) {
    if (!noted_at_.isZero()) quiet_since_ = noted_message_;
    noted_message_ = message_;
    noted_at_ = now;
  }
  std::size_t work = 0;
  for (; work < kSlice && !waiting_.empty() && *readers_before_ == 0; ++work) {
    names_.reuse(waiting_.back());
    waiting_.pop_back();
  }
  while (work < kSlice && inUse() > kept) {
    if (next_ == edges_.size()) return endPass();
    work += visit(next_++, kept);
  }
}

/// Returns how many edges and samples it looked at or forgot.
std::size_t TransformBuffer::visit(Frame frame, std::size_t kept_static) {
  Edge& edge = edges_[frame];
  if (edge.is_unused) return 1;
  const bool is_watched = edge.watched > 0 && edge.watched + 1 >= pass_;
  if (edge.holds > 0 || is_watched || edge.message > quiet_since_) return reference(frame);
  if (edge.is_static && !edge.is_kept && kept_static_ < kept_static) {
    edge.is_kept = true;
    ++kept_static_;
  }
  if (edge.is_kept) return reference(frame);
  const std::size_t work = 1 + (edge.history ? edge.history->samples().size() : 0);
  names_.forgetEdge(frame);
  Edge forgotten;
  forgotten.is_met = edge.is_met;
  forgotten.referenced = edge.referenced;
  forgotten.needs = edge.needs;
  forgotten.was_needed = edge.was_needed;
  edge = std::move(forgotten);
  if (edge.referenced + 1 >= pass_) return work;
  names_.forget(frame);
  edge.is_met = false;
  edge.is_unused = true;
  ++unused_;
  forgotten_.push_back(frame);
  return work;
}

/// Marks all parents of the edge, so that they keep their names in this pass and the next. Returns
/// the same as visit().
std::size_t TransformBuffer::reference(Frame child) {
  const Edge& edge = edges_[child];
  if (const auto parent = names_.cachedParent(child)) edges_[*parent].referenced = pass_;
  if (edge.has_parent) edges_[edge.parent].referenced = pass_;
  if (!edge.had_others || !edge.history) return 1;
  const SampleRing& samples = edge.history->samples();
  for (std::size_t i = 0; i < samples.size(); ++i)
    edges_[samples[i].parent].referenced = pass_;
  return 1 + samples.size();
}

void TransformBuffer::endPass() {
  ++pass_;
  next_ = 0;
  if (!waiting_.empty() || *readers_before_ > 0) return;
  waiting_ = std::exchange(forgotten_, {});
  readers_before_ = std::exchange(readers_, std::make_shared<std::atomic<int>>(0));
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes each frame after its parent.
#include "world/history/way_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/tf/frame_paths.h"
#include "world/tf/tf2_pose.h"

namespace link_bounds {
namespace {

/// The angle T of an edge follows from the chord of its two quaternions: T <= 1.111 |q1 - q0| for
/// all angles up to pi/2. The factor is pi/2 / sqrt(2), rounded up by more than quaternions whose
/// squared length is within kMaxLength2Error of 1 can add.
constexpr double kAnglePerChord = 1.111;
constexpr double kMaxLength2Error = 1e-6;  // of squared lengths of quaternions

struct Square {
  double chord2;  ///< squared distance of two quaternions, or of one and the other negated: the min
  double length2_error;
  double length2_change;
};

Square squareOf(const Tf2Pose& a, const Tf2Pose& b) {
  double dot = 0, a2 = 0, b2 = 0;
  for (std::size_t i = 3; i < 7; ++i) {
    dot += a.numbers[i] * b.numbers[i];
    a2 += a.numbers[i] * a.numbers[i];
    b2 += b.numbers[i] * b.numbers[i];
  }
  const double sign = dot < 0 ? -1 : 1;
  double chord2 = 0;
  for (std::size_t i = 3; i < 7; ++i) {
    const double change = b.numbers[i] - sign * a.numbers[i];
    chord2 += change * change;
  }
  return {chord2, std::max(std::abs(a2 - 1), std::abs(b2 - 1)), std::abs(a2 - b2)};
}

double length(const Tf2Pose& pose) {
  const auto& n = pose.numbers;
  return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

double shiftOf(const Tf2Pose& a, const Tf2Pose& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += (b.numbers[i] - a.numbers[i]) * (b.numbers[i] - a.numbers[i]);
  return std::sqrt(sum);
}

constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr double kWayRounding = 1e-12;  // of all coordinates, relative to the largest

/// The edge from the child of `inner` to the parent of `outer`. The parent of `inner` is the child
/// of `outer`.
EdgeWay chained(const EdgeWay& outer, const EdgeWay& inner) {
  EdgeWay result;
  result.scale = outer.scale * inner.scale;
  result.inverse = outer.inverse * inner.inverse;
  result.turn = outer.turn * inner.scale + outer.scale * inner.turn;
  result.stretch = outer.stretch + inner.stretch;
  result.shift = outer.shift + outer.turn * inner.distance + outer.scale * inner.shift;
  result.distance = outer.distance + outer.scale * inner.distance;
  return result;
}

}  // namespace

const std::optional<EdgeWay>& EdgeWays::during(Frame child, MotionSpan span) {
  if (child >= looks_.size()) looks_.resize(std::max<std::size_t>(tf_.size(), child + 1));
  Look& last = looks_[child];
  const bool is_known = last.version == tf_.version() && last.version != 0 &&
                        last.span.begin == span.begin && last.span.end == span.end;
  if (!is_known) last = {tf_.version(), span, look(child, span)};
  return last.way;
}

/// Goes back from the newest sample to the last one at or before the begin of the span.
std::optional<EdgeWay> EdgeWays::look(Frame child, MotionSpan span) const {
  const EdgeHistory* const history = tf_.history(child);
  if (!history || history->samples().isEmpty() || !tf_.hasParent(child)) return std::nullopt;
  const SampleRing& samples = history->samples();
  std::size_t i = samples.size() - 1;
  EdgeWay edge;
  const auto take = [&](const Tf2Pose& pose) {
    edge.distance = std::max(edge.distance, length(pose));
  };
  if (tf_.isStatic(child)) {
    const EdgeSample& sample = samples[i];
    const Square square = squareOf(sample.parent_from_child, sample.parent_from_child);
    if (!(square.length2_error <= kMaxLength2Error)) return std::nullopt;
    edge.scale = 1 + square.length2_error;
    edge.inverse = 1 + 2 * square.length2_error;
    take(sample.parent_from_child);
    return edge;
  }
  if (samples[i].stamp < span.end) return std::nullopt;
  while (i > 0 && samples[i - 1].stamp >= span.end)
    --i;
  take(samples[i].parent_from_child);
  for (; samples[i].stamp > span.begin; --i) {
    if (i == 0 || samples[i - 1].stamp < history->oldestKept()) return std::nullopt;
    const EdgeSample& older = samples[i - 1];
    const EdgeSample& newer = samples[i];
    if (older.parent != tf_.parent(child) || newer.parent != older.parent) return std::nullopt;
    const Tf2Pose& from = older.parent_from_child;
    const Tf2Pose& to = newer.parent_from_child;
    const Square square = squareOf(from, to);
    if (!(square.length2_error <= kMaxLength2Error)) return std::nullopt;
    take(from);
    edge.shift += shiftOf(from, to);
    edge.scale = std::max(edge.scale, 1 + square.length2_error);
    edge.inverse = std::max(edge.inverse, 1 + 2 * square.length2_error);
    if (square.chord2 == 0) continue;
    const double change = 0.51 * square.length2_change + kLengthError;
    edge.turn += 2 * (kAnglePerChord * std::sqrt(square.chord2) + kAngleError + 1.6 * change);
    edge.stretch += 20.1 * change;
  }
  return edge;
}

double WayBound::of(Frame source, double radius, MotionSpan span) {
  if (version_ != tf_.version() || span.begin != span_.begin || span.end != span_.end) begin(span);
  const Node& node = nodeOf(source);
  if (!node.is_known) return kInfinite;
  const Height& height = heights_[node.height];
  const EdgeWay& link = node.top_from_node;
  const EdgeWay& target = height.top_from_target;
  // Steps 5, 3 and 4 of deviation_bound.h.
  const double start = link.inverse * target.inverse * radius;
  const double start_way = (link.stretch + target.stretch) * start;
  const double distance = link.distance + link.scale * start + target.distance;
  const double way = link.shift + link.turn * start + link.scale * start_way + target.shift;
  const double all =
      height.turned_turn * distance + height.turned_scale * way + kWayRounding * distance;
  return all < kInfinite ? all : kInfinite;  // nor NaN, which an infinite length times 0 gives
}

/// Makes the nodes of the target and its ancestors first, because all ways end at one of them.
void WayBound::begin(MotionSpan span) {
  version_ = tf_.version();
  span_ = span;
  ++run_;
  nodes_.resize(tf_.size());
  heights_.assign(1, Height());
  climb(tf_, target_, [this](Frame frame) {
    Node& node = nodes_[frame];
    if (node.run == run_) return true;  // a loop
    node = {run_, true, heights_.size() - 1, EdgeWay()};
    const std::optional<EdgeWay>& edge = edges_.during(frame, span_);
    if (!edge) return true;
    const Height& below = heights_.back();
    Height next;
    next.top_from_target = chained(*edge, below.top_from_target);
    next.turned_turn = below.turned_scale * edge->turn + below.turned_turn * edge->scale;
    next.turned_scale = below.turned_scale * edge->scale;
    heights_.push_back(next);
    return false;
  });
}

const WayBound::Node& WayBound::nodeOf(Frame source) {
  way_.clear();
  climb(tf_, source, [this](Frame frame) {
    if (frame >= nodes_.size()) nodes_.resize(tf_.size());
    Node& node = nodes_[frame];
    if (node.run == run_) return true;
    node = {run_, false, 0, EdgeWay()};
    way_.push_back(frame);
    return false;
  });
  for (std::size_t i = way_.size(); i-- > 0;) {
    if (!tf_.hasParent(way_[i])) continue;
    const Node& above = nodes_[tf_.parent(way_[i])];
    if (!above.is_known) continue;
    const std::optional<EdgeWay>& edge = edges_.during(way_[i], span_);
    if (edge) nodes_[way_[i]] = {run_, true, above.height, chained(above.top_from_node, *edge)};
  }
  return nodes_[source];
}

}  // namespace link_bounds

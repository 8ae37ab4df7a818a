// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The angle T of an edge comes from the chord of its two quaternions: T <= 1.111 |q1 - q0| for all
// angles up to pi/2.
#include "world/history/edge_ways.h"

#include <algorithm>
#include <cmath>

#include "world/tf/tf2_pose.h"

namespace link_bounds {
namespace {

/// pi/2 / sqrt(2), rounded up by more than lengths within kMaxLength2Error of 1 can add.
constexpr double kAnglePerChord = 1.111;
constexpr double kMaxLength2Error = 1e-6;  // of squares of lengths of quaternions

struct Square {
  double chord2;  ///< of two quaternions, of which one is negated if they are nearer then
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

}  // namespace

const std::optional<EdgeWay>& EdgeWays::during(Frame child, MotionSpan span) {
  if (child >= looks_.size()) looks_.resize(std::max<std::size_t>(tf_.size(), child + 1));
  Look& last = looks_[child];
  const bool is_known = last.version == tf_.version() && last.version != 0 &&
                        last.span.begin == span.begin && last.span.end == span.end;
  if (!is_known) last = {tf_.version(), span, look(child, span)};
  return last.way;
}

/// From the newest sample back to the last one that is not within the span.
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

}  // namespace link_bounds

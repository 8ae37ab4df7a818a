// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Climbs the tf tree like TransformBuffer::pose, but for a span instead of one time.
#include "world/history/motion_path.h"

#include <algorithm>

#include "text/joined.h"
#include "world/history/pose_gap.h"
#include "world/tf/frame_paths.h"

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;
using Samples = std::vector<const EdgeSample*>;

std::string seconds(std::int64_t nanoseconds) {
  return secondsText(nanoseconds) + " s";
}

/// The way up from a frame, as far as tf knows it for the whole span.
struct Climb {
  std::vector<Frame> frames;  ///< the start, then the parent of each edge
  std::vector<EdgeMotion> edges;
  std::string problem;  ///< why the way ends early; "" at isEnd() and at the root of a tf tree
};

class Climber {
 public:
  Climber(const TransformBuffer& tf, MotionSpan span, double timeout)
      : tf_(tf), span_(span), timeout_(timeout) {}

  /// Climbs until isEnd(frame), or as far as possible.
  template <class IsEnd>
  Climb climb(Frame frame, IsEnd isEnd) const {
    Climb result;
    result.frames.push_back(frame);
    while (!isEnd(frame)) {
      const EdgeHistory* history = tf_.history(frame);
      if (!history || history->samples().isEmpty()) break;
      Samples samples = history->between(span_.begin, span_.end);
      result.problem = samples.empty() ? notCovered(frame, *history) : problemOf(frame, samples);
      if (!result.problem.empty()) break;
      frame = samples.front()->parent;
      if (result.edges.size() > tf_.size()) {
        result.problem = "the parents of frame " + quoted(tf_.name(frame)) + " form a loop";
        break;
      }
      result.frames.push_back(frame);
      result.edges.emplace_back(std::move(samples));
    }
    return result;
  }

 private:
  std::string notCovered(Frame frame, const EdgeHistory& history) const {
    const std::int64_t oldest = history.oldestStamp();
    // "on": an excerpt of tf may end soon after the span, so its newest stamp says nothing.
    const std::string known = oldest > span_.begin
                                  ? "from " + seconds(oldest) + " on"
                                  : "up to " + seconds(history.samples().newest().stamp);
    return "tf knows frame " + quoted(tf_.name(frame)) + " only " + known +
           ", which does not cover the span from " + seconds(span_.begin) + " to " +
           seconds(span_.end);
  }

  std::string problemOf(Frame frame, const Samples& samples) const {
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const EdgeSample& older = *samples[i - 1];
      const EdgeSample& newer = *samples[i];
      const bool is_gap =
          timeout_ > 0 && static_cast<double>(newer.stamp - older.stamp) > timeout_ * 1e9;
      if (older.parent != newer.parent || is_gap) return problemBetween(frame, older, newer);
    }
    return "";
  }

  std::string problemBetween(Frame frame, const EdgeSample& older, const EdgeSample& newer) const {
    const std::string who = "frame " + quoted(tf_.name(frame));
    const std::string where = " between " + seconds(older.stamp) + " and " + seconds(newer.stamp);
    if (older.parent == newer.parent)
      return who + " has no transform" + where + ", which is longer than timeout";
    return who + " changes its parent from " + quoted(tf_.name(older.parent)) + " to " +
           quoted(tf_.name(newer.parent)) + where;
  }

  const TransformBuffer& tf_;
  MotionSpan span_;
  double timeout_;
};

}  // namespace

void MotionPath::addSampleTimes(MotionSpan span, std::vector<std::int64_t>& times) const {
  for (const auto* edges : {&from_source, &from_target}) {
    for (const EdgeMotion& edge : *edges) {
      if (!edge.isMoving()) continue;
      for (const EdgeSample* sample : edge.samples()) {
        if (sample->stamp > span.begin && sample->stamp < span.end) times.push_back(sample->stamp);
      }
    }
  }
}

void MotionPath::seek(std::int64_t time) {
  for (auto* edges : {&from_source, &from_target}) {
    for (EdgeMotion& edge : *edges)
      edge.seek(time);
  }
}

void MotionPath::followLibrary(bool is_library) {
  for (auto* edges : {&from_source, &from_target}) {
    for (EdgeMotion& edge : *edges)
      edge.followLibrary(is_library);
  }
}

Tf2Pose MotionPath::targetFromSource(std::int64_t time) const {
  Tf2Pose top_from_source, top_from_target;
  for (const EdgeMotion& edge : from_source)
    top_from_source = edge.at(time) * top_from_source;
  for (const EdgeMotion& edge : from_target)
    top_from_target = edge.at(time) * top_from_target;
  return from_target.empty() ? top_from_source : inverse(top_from_target) * top_from_source;
}

void fillSteps(const std::vector<EdgeMotion>& edges, std::int64_t duration,
               std::vector<EdgeStep>& steps) {
  steps.clear();
  for (const EdgeMotion& edge : edges)
    steps.push_back(edge.stepIn(duration));
}

MotionPath pathBetween(const TransformBuffer& tf, Frame target, Frame source, MotionSpan span,
                       double timeout) {
  const Climber climber(tf, span, timeout);
  Climb up = climber.climb(source, [&](Frame frame) { return frame == target; });
  const auto place = [&](Frame frame) {
    return std::find(up.frames.begin(), up.frames.end(), frame);
  };
  const auto is_met = [&](Frame frame) { return place(frame) != up.frames.end(); };
  Climb down = climber.climb(target, is_met);
  const auto top = place(down.frames.back());
  if (top == up.frames.end()) {
    std::string problem = up.problem.empty() ? down.problem : up.problem;
    if (problem.empty())
      problem = "no transform from " + quoted(tf.name(source)) + " to " + quoted(tf.name(target));
    return {{}, {}, problem};
  }
  up.edges.erase(up.edges.begin() + (top - up.frames.begin()), up.edges.end());
  return {std::move(up.edges), std::move(down.edges), ""};
}

std::int64_t oldestKnown(const TransformBuffer& tf, Frame target, Frame source) {
  std::int64_t oldest = 0;
  for (const Frame frame : edgesBetween(tf, target, source)) {
    const EdgeHistory* history = tf.history(frame);
    if (history && !tf.isStatic(frame) && !history->samples().isEmpty())
      oldest = std::max(oldest, history->oldestStamp());
  }
  return oldest;
}

}  // namespace link_bounds

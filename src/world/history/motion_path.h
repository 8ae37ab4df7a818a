// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The edges of tf between two frames during a span.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "world/history/edge_motion.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// A closed interval [ns of ROS time]; begin <= end.
struct MotionSpan {
  std::int64_t begin;
  std::int64_t end;
};

/// Each list leads up to the nearest common ancestor of both frames.
struct MotionPath {
  std::vector<EdgeMotion> from_source;
  std::vector<EdgeMotion> from_target;
  std::string problem;  ///< why the motion is not known, in words; "" if it is

  bool isMoving() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isMoving(); });
  }

  /// Appends the stamps of all samples of moving edges strictly inside the span, in any order.
  void addSampleTimes(MotionSpan span, std::vector<std::int64_t>& times) const;

  /// Selects the interval from the last sample at or before this time [ns] to the next sample. The
  /// functions below refer to this interval.
  void seek(std::int64_t time);

  /// True if tf2 may move an edge in two ways: see step 6 of deviation_bound.h.
  bool isAmbiguous() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isAmbiguous(); });
  }

  /// True if an edge jumps at the next sample: its interpolation ends one nanosecond before that.
  bool isSudden() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isSudden(); });
  }

  /// See EdgeMotion::followLibrary.
  void followLibrary(bool is_library);

  /// The pose of the source in the target, multiplied in the order of TransformBuffer::pose.
  Tf2Pose targetFromSource(std::int64_t time) const;

 private:
  template <class Test>
  bool anyEdge(Test test) const {
    return std::any_of(from_source.begin(), from_source.end(), test) ||
           std::any_of(from_target.begin(), from_target.end(), test);
  }
};

/// Fills `steps`, whose memory is reused, with EdgeMotion::stepIn of each edge.
void fillSteps(const std::vector<EdgeMotion>& edges, std::int64_t duration,
               std::vector<EdgeStep>& steps);

/// The path has a problem if an edge changes its parent during the span, or if two successive
/// samples are further apart than `timeout` (seconds; 0: no limit). The path is valid as long as tf
/// does not change.
MotionPath pathBetween(const TransformBuffer& tf, TransformBuffer::Frame target,
                       TransformBuffer::Frame source, MotionSpan span, double timeout);

/// The stamp from which on tf has the history of all edges between both frames, according to their
/// present parents; 0 if all edges are static.
std::int64_t oldestKnown(const TransformBuffer& tf, TransformBuffer::Frame target,
                         TransformBuffer::Frame source);

}  // namespace link_bounds

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

/// Both ends count [ns of ROS time], begin <= end.
struct MotionSpan {
  std::int64_t begin;
  std::int64_t end;
};

/// Each list goes up to the nearest frame above both.
struct MotionPath {
  std::vector<EdgeMotion> from_source;
  std::vector<EdgeMotion> from_target;
  std::string problem;  ///< why the motion is not known, in words; "" if it is

  bool isMoving() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isMoving(); });
  }

  /// The stamps of the samples of edges that move, within the span but for its ends, in any order.
  void addSampleTimes(MotionSpan span, std::vector<std::int64_t>& times) const;

  /// The functions below are about the time from the sample at or before this one to the next one.
  void seek(std::int64_t time);

  /// True if tf2 may move it in two ways: see step 6 of deviation_bound.h.
  bool isAmbiguous() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isAmbiguous(); });
  }

  /// True if an edge jumps at the next sample: its motion ends one nanosecond before.
  bool isSudden() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isSudden(); });
  }

  /// As EdgeMotion::followLibrary.
  void followLibrary(bool is_library);

  /// The pose of the source in the target. The products are those of TransformBuffer::pose.
  Tf2Pose targetFromSource(std::int64_t time) const;

 private:
  template <class Test>
  bool anyEdge(Test test) const {
    return std::any_of(from_source.begin(), from_source.end(), test) ||
           std::any_of(from_target.begin(), from_target.end(), test);
  }
};

/// What the edges do in that time, from its begin on, in memory that is reused.
void fillSteps(const std::vector<EdgeMotion>& edges, std::int64_t duration,
               std::vector<EdgeStep>& steps);

/// The edges must have had the same parents during the whole span, and no two samples in it that
/// follow each other may be further apart than `timeout` (seconds; 0: they may be). The path is
/// valid as long as tf does not change.
MotionPath pathBetween(const TransformBuffer& tf, TransformBuffer::Frame target,
                       TransformBuffer::Frame source, MotionSpan span, double timeout);

/// From this stamp on tf has not forgotten any edge between both, by their present parents.
std::int64_t oldestKnown(const TransformBuffer& tf, TransformBuffer::Frame target,
                         TransformBuffer::Frame source);

}  // namespace link_bounds

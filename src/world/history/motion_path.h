// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The edges of tf between two frames during a span.
#pragma once

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
};

/// The edges must have had the same parents during the whole span, and no two samples in it that
/// follow each other may be further apart than `timeout` (seconds; 0: they may be). The path is
/// valid as long as tf does not change.
MotionPath pathBetween(const TransformBuffer& tf, TransformBuffer::Frame target,
                       TransformBuffer::Frame source, MotionSpan span, double timeout);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How much an edge of tf does during a span, whatever is behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/history/motion_path.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// From the child to its parent, as tf2 interpolates; all are the largest during the span.
struct EdgeWay {
  double scale = 1;     ///< |q|^2
  double inverse = 1;   ///< 1 / |q|^2
  double turn = 0;      ///< [rad], of the product, which turns by twice the angle of quaternions
  double stretch = 0;   ///< e of deviation_bound.h
  double shift = 0;     ///< [m]
  double distance = 0;  ///< of the child's origin from the parent's [m]
};

/// Remembers the last look at each edge, so that all who bound ways in different frames share it:
/// of zones in two frames each edge is looked at once.
class EdgeWays {
 public:
  using Frame = TransformBuffer::Frame;

  /// `tf` must outlive this.
  explicit EdgeWays(const TransformBuffer& tf) : tf_(tf) {}

  const TransformBuffer& tf() const { return tf_; }

  /// Nothing if that is not known in this cheap way: the history does not cover the span, the edge
  /// changes its parent, or a quaternion is not of length 1. Valid until the next call.
  const std::optional<EdgeWay>& during(Frame child, MotionSpan span);

 private:
  struct Look {
    std::uint64_t version = 0;  ///< of tf; 0: never looked
    MotionSpan span{0, -1};
    std::optional<EdgeWay> way;
  };

  std::optional<EdgeWay> look(Frame child, MotionSpan span) const;

  const TransformBuffer& tf_;
  std::vector<Look> looks_;  ///< by child
};

}  // namespace link_bounds

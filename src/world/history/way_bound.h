// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long the way of any point of a link is, at most: a bound that costs some 30 ns for a link, so
// that only motions near something need the walk of motion_walk.h.
//
// It is step 3 of deviation_bound.h without accelerations: what an edge adds is its turn times the
// distance of the point from the child's origin, and its shift. Both are linear in that distance,
// so that one look at each edge serves all links behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/history/motion_path.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// How much an edge of tf, or several in a row, do during a span, whatever is behind them: from the
/// child to its parent, as tf2 interpolates; all are the largest during the span. A point at a
/// distance x from the origin of the child, which moves there by w, has in the parent at most the
/// distance `distance` + scale x and the way shift + turn x + scale w.
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

class WayBound {
 public:
  using Frame = TransformBuffer::Frame;

  /// Bounds ways in the frame `target`. `edges` and its tf must outlive this.
  WayBound(EdgeWays& edges, Frame target) : edges_(edges), tf_(edges.tf()), target_(target) {}

  /// No point that is at most `radius` from the origin of `source` [m] has a longer way during the
  /// span, as tf2 interpolates [m]. Infinite if EdgeWays does not know an edge. Between two calls
  /// tf may have changed.
  double of(Frame source, double radius, MotionSpan span);

 private:
  struct Node {
    std::uint64_t run = 0;  ///< in which it was computed
    bool is_known = false;
    std::size_t height = 0;  ///< of the frame above the target that its way leads to
    EdgeWay top_from_node;
  };

  /// From the target up to one of the frames above it.
  struct Height {
    EdgeWay top_from_target;
    double turned_turn = 0;  ///< back from the top into the axes of the target
    double turned_scale = 1;
  };

  void begin(MotionSpan span);
  const Node& nodeOf(Frame source);

  EdgeWays& edges_;
  const TransformBuffer& tf_;
  Frame target_;
  MotionSpan span_{0, -1};
  std::uint64_t version_ = 0;  ///< of tf
  std::uint64_t run_ = 0;      ///< counts spans and versions
  std::vector<Node> nodes_;    ///< by frame
  std::vector<Height> heights_;
  std::vector<Frame> way_;  ///< memory that is reused
};

}  // namespace link_bounds

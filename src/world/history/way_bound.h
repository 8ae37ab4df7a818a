// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// An upper bound of the path length of each point of a link. It takes some 30 ns per link, so that
// only links near other bodies need the walk of motion_walk.h.
//
// It is step 3 of deviation_bound.h without accelerations: an edge adds its turn times the distance
// of the point from the child's origin, plus its shift. That is linear in the distance, so that one
// look at each edge serves all links below it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/history/motion_path.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// The motion of an edge of tf, or of several in a row, from child to parent during a span, as tf2
/// interpolates. Each number is an upper bound for the whole span. A point whose distance from the
/// origin of the child is x, and whose path in the child has length w, has in the parent at most
/// the distance `distance` + scale x and the path length shift + turn x + scale w.
struct EdgeWay {
  double scale = 1;     ///< |q|^2
  double inverse = 1;   ///< 1 / |q|^2
  double turn = 0;      ///< rotation angle [rad], twice the angle between the quaternions
  double stretch = 0;   ///< e of deviation_bound.h
  double shift = 0;     ///< path length of the child's origin in the parent [m]
  double distance = 0;  ///< between the origins of child and parent [m]
};

/// Caches the motion of each edge. WayBounds with different target frames share it: for zones in
/// two frames each edge is read once.
class EdgeWays {
 public:
  using Frame = TransformBuffer::Frame;

  /// `tf` must outlive this.
  explicit EdgeWays(const TransformBuffer& tf) : tf_(tf) {}

  const TransformBuffer& tf() const { return tf_; }

  /// The motion of the edge above `child`. Nothing without an edge, or if this fast method cannot
  /// bound it: the history does not cover the span, the child had another parent in it than now, or
  /// a quaternion does not have length 1.
  /// Valid until the next call.
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

  /// Upper bound of the path length during the span [m], as tf2 interpolates, of each point that is
  /// at most `radius` [m] from the origin of `source`. Infinite if EdgeWays cannot bound an edge.
  /// tf may change between two calls.
  double of(Frame source, double radius, MotionSpan span);

 private:
  struct Node {
    std::uint64_t run = 0;  ///< value of run_ when it was computed
    bool is_known = false;
    std::size_t height = 0;  ///< index in heights_ of the first common ancestor with the target
    EdgeWay top_from_node;
  };

  /// The way from the target up to one of its ancestors, the top.
  struct Height {
    EdgeWay top_from_target;
    double turned_turn = 0;  ///< for vectors turned from the axes of the top into the target's
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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The histories of all edges, and poses between any two frames at a time.
//
// tf2's BufferCore has the same inside, but it cannot forget a single edge, prints a line for each
// transform it refuses, and looks up names for each pose.
#pragma once

#include <optional>
#include <vector>

#include "node/tf/edge_history.h"
#include "node/tf/frame_tree.h"

namespace link_bounds {

class EdgeHistories {
 public:
  using Frame = FrameTree::Frame;

  /// False if it is refused: the stamp is there already, or too old. The first transform decides
  /// whether an edge is static.
  bool insert(Frame child, Frame parent, std::int64_t stamp, const Tf2Pose& parent_from_child,
              bool is_static);

  /// Static edges stay.
  void clear();
  void clear(Frame child);

  /// One edge at a time, see EdgeHistory.
  const EdgeSample* at(Frame child, std::int64_t stamp, EdgeSample& scratch) const {
    return histories_[child] ? histories_[child]->at(stamp, scratch) : nullptr;
  }

  /// By the edges as they were at that time, interpolated; at time 0 the newest of each edge.
  /// Nothing if a history does not reach the time, or if the way up from the source runs into a
  /// loop before it meets the target.
  std::optional<Tf2Pose> pose(Frame target, Frame source, std::int64_t stamp) const;

 private:
  struct Step {
    Frame frame;
    Tf2Pose frame_from_source;
  };

  bool climb(Frame source, Frame target, std::int64_t stamp) const;

  std::vector<std::optional<EdgeHistory>> histories_;  ///< by child
  mutable std::vector<Step> steps_;                    ///< the last climb, from the source upwards
  mutable WalkMarks marks_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Who is whose parent in tf, and when each edge was last heard of.
//
// tf2's histories keep the transforms; they do not tell when one arrived or what a message touched,
// which is what decides about recomputing boxes and about stale links.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "node/tf/frame_names.h"
#include "node/tf/walk_marks.h"

namespace link_bounds {

/// An edge is named by its child frame. Times are nanoseconds of ROS time.
class FrameTree {
 public:
  using Frame = FrameNames::Frame;

  /// A number for the name, the same for ever.
  Frame frame(std::string_view name) { return known(names_.frame(name)); }

  /// The same for the next transform of a message; quick where it is as in an earlier message, see
  /// FrameNames.
  FrameNames::Edge next(std::string_view parent, std::string_view child, std::string_view key) {
    const FrameNames::Edge edge = names_.next(parent, child, key);
    known(std::max(edge.child, edge.parent));
    return edge;
  }

  /// tf accepted a transform. Whether an edge is static is decided by the first one, as in tf2.
  void heard(Frame child, Frame parent, bool is_static, std::int64_t stamp, std::int64_t now);

  /// The number of frames.
  std::size_t size() const { return edges_.size(); }

  /// Begins a new message: changedSince(...) then speaks of edges heard from here on.
  void beginMessage() {
    ++message_;
    names_.beginMessage();
  }

  /// tf was cleared: only static edges remain.
  void forgetDynamic();

  /// The history of one edge was cleared.
  void forget(Frame edge);

  /// Until they are heard again, edges with a newer stamp than this are distrusted.
  void distrustStampsAfter(std::int64_t stamp);
  bool isDistrusted(Frame edge) const { return edges_[edge].is_distrusted; }

  /// Edges heard before the clock ran count as heard now.
  void clockStarted(std::int64_t now);

  /// The edges between two frames, by the newest parents; nothing if they are not connected. As in
  /// tf2, the way up from `from` may meet `to`, but must not run into a loop before that.
  std::optional<std::vector<Frame>> path(Frame from, Frame to) const;

  /// True if the edge was heard in this message.
  bool isNews(Frame edge) const { return edges_[edge].message == message_; }

  /// False at the top of a tree.
  bool hasParent(Frame edge) const { return edges_[edge].exists; }

  /// By the newest transform.
  Frame parent(Frame edge) const { return edges_[edge].parent; }
  bool isStatic(Frame edge) const { return edges_[edge].is_static; }
  std::int64_t lastHeard(Frame edge) const { return edges_[edge].heard; }

  /// The newest stamp of the edge; 0 if it is static or forgotten.
  std::int64_t newest(Frame edge) const { return edges_[edge].newest; }

  /// Changes whenever a path may have changed, now or in the past.
  std::uint64_t structure() const { return structure_; }

  /// From this stamp on each edge had the parent that it has now.
  std::int64_t settled() const { return settled_; }

 private:
  struct Edge {
    Frame parent = 0;
    bool exists = false;    ///< a transform was heard since the last forgetDynamic()
    bool is_known = false;  ///< a transform was ever heard
    bool is_static = false;
    bool is_distrusted = false;
    std::int64_t newest = 0;
    std::int64_t heard = 0;
    std::uint64_t message = 0;
  };

  Frame known(Frame frame) {
    if (frame >= edges_.size()) edges_.resize(frame + 1);
    return frame;
  }

  FrameNames names_;
  std::vector<Edge> edges_;  ///< by child
  std::uint64_t message_ = 1;
  std::uint64_t structure_ = 1;
  std::int64_t settled_ = 0;
  mutable WalkMarks marks_;
};

}  // namespace link_bounds

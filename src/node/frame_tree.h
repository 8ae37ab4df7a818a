// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Who is whose parent in tf, and when each edge was last heard of.
//
// tf2 keeps the transforms; it does not tell when one arrived or what a message touched, which is
// what decides about recomputing boxes and about stale links.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace link_bounds {

/// An edge is named by its child frame. Times are nanoseconds of ROS time.
class FrameTree {
 public:
  using Frame = std::size_t;

  /// A number for the name, the same for ever.
  Frame frame(const std::string& name);

  /// tf accepted a transform. Whether an edge is static is decided by the first one, as in tf2.
  void heard(Frame child, Frame parent, bool is_static, std::int64_t stamp, std::int64_t now);

  /// Begins a new message: changedSince(...) then speaks of edges heard from here on.
  void beginMessage() { ++message_; }

  /// tf was cleared: only static edges remain.
  void forgetDynamic();

  /// Edges heard before the clock ran count as heard now.
  void clockStarted(std::int64_t now);

  /// The edges between two frames, by the newest parents; nothing if they are not connected.
  std::optional<std::vector<Frame>> path(Frame from, Frame to) const;

  /// True if the edge was heard in this message.
  bool isNews(Frame edge) const { return edges_[edge].message == message_; }

  bool isStatic(Frame edge) const { return edges_[edge].is_static; }
  std::int64_t lastHeard(Frame edge) const { return edges_[edge].heard; }

  /// Changes whenever a path may have changed.
  std::uint64_t structure() const { return structure_; }

 private:
  struct Edge {
    Frame parent = 0;
    bool exists = false;    ///< a transform was heard since the last forgetDynamic()
    bool is_known = false;  ///< a transform was ever heard
    bool is_static = false;
    std::int64_t newest = 0;
    std::int64_t heard = 0;
    std::uint64_t message = 0;
  };

  std::vector<Frame> ancestors(Frame from) const;

  std::unordered_map<std::string, Frame> frames_;
  std::vector<Edge> edges_;  ///< by child
  std::uint64_t message_ = 1;
  std::uint64_t structure_ = 1;
};

}  // namespace link_bounds

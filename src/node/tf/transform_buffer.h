// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All transforms of the last ten seconds, in one table of edges.
//
// tf2::BufferCore keeps the same transforms. It cannot say when one was received or which edges a
// message touched, which decides about recomputing boxes and about stale frames; it cannot forget
// a single edge; and it prints a line for each transform that it refuses.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "node/tf/edge_history.h"
#include "node/tf/frame_names.h"
#include "node/tf/tf_message.h"
#include "node/tf/walk_marks.h"

namespace link_bounds {

/// A transform that was not accepted.
struct Refusal {
  std::size_t index;   ///< its place in the message
  const char* reason;  ///< with the remedy
};

/// How many transforms were accepted and refused since the start.
struct TfIntake {
  std::uint64_t accepted = 0;
  std::uint64_t late = 0;      ///< accepted with a stamp before the newest one of their frame
  std::uint64_t repeated = 0;  ///< refused: there is one of that stamp already
  std::uint64_t too_old = 0;   ///< refused
  std::uint64_t unusable = 0;  ///< refused: see whyRefused
  std::uint64_t dropped = 0;   ///< refused: sent before the clock jumped
};

/// An edge leads from a frame to its parent and is named by the frame, the child. Times are
/// nanoseconds of ROS time.
class TransformBuffer {
 public:
  using Frame = FrameNames::Frame;

  TransformBuffer() = default;
  TransformBuffer(const TransformBuffer&) = delete;
  TransformBuffer& operator=(const TransformBuffer&) = delete;

  /// A number for the name, which never changes.
  Frame frame(std::string_view name);

  /// The same, but nothing for a name that was never met; the buffer stays as it is.
  std::optional<Frame> find(std::string_view name) const { return names_.known(name); }

  const std::string& name(Frame frame) const { return names_.name(frame); }

  /// The number of frames.
  std::size_t size() const { return edges_.size(); }

  /// Adds the transforms of one message, received at `now`. Refused ones change nothing. Repeated
  /// stamps, and old ones on an edge that still receives good data, are counted but not reported.
  std::vector<Refusal> add(const std::vector<TransformView>& transforms, bool is_static,
                           ros::Time now);

  /// As tf2's lookupTransform(target, source, stamp): by the edges as they were at that time,
  /// interpolated; at time 0 the newest of each edge. Nothing if a history does not reach the time,
  /// or if the way up from the source runs into a loop before it meets the target. A frame in
  /// itself needs no transform. The result may not be finite.
  std::optional<Tf2Pose> pose(Frame target, Frame source, std::int64_t stamp) const;

  /// Forgets everything that is not static, after a clock jump.
  void clear();

  /// Counts transforms that were sent before a clock jump, instead of add().
  void countDropped(std::size_t count) { intake_.dropped += count; }

  /// An edge whose newest stamp is so far ahead of `now` that tf refuses all stamps of correct
  /// clocks may begin again: the next transform that is too old replaces its history.
  void distrustStampsAhead(ros::Time now);

  /// Edges received before the clock ran count as received now.
  void startClock(ros::Time now);

  const TfIntake& intake() const { return intake_; }

  /// True if the last message had this edge.
  bool isNews(Frame child) const { return edges_[child].message == message_; }

  /// True once an accepted transform had the frame, as child or as parent.
  bool isMet(Frame frame) const { return edges_[frame].is_met; }

  /// False at the top of a tree.
  bool hasParent(Frame child) const { return edges_[child].has_parent; }

  /// By the newest transform. There must be one.
  Frame parent(Frame child) const { return edges_[child].parent; }

  /// Decided by the first transform, as in tf2.
  bool isStatic(Frame child) const { return edges_[child].is_static; }

  /// The newest stamp; 0 if the edge is static or has no transform.
  std::int64_t newest(Frame child) const { return edges_[child].newest; }

  /// When the last transform was accepted.
  std::int64_t received(Frame child) const { return edges_[child].received; }

  /// The transform of one edge, see EdgeHistory.
  const EdgeSample* at(Frame child, std::int64_t stamp, EdgeSample& scratch) const {
    return edges_[child].history ? edges_[child].history->at(stamp, scratch) : nullptr;
  }

  /// Null before the first transform of the edge.
  const EdgeHistory* history(Frame child) const {
    return edges_[child].history ? &*edges_[child].history : nullptr;
  }

  /// Changes with each message and each clear().
  std::uint64_t version() const { return message_; }

  /// Changes whenever an edge may lead to another parent, now or in the past.
  std::uint64_t structure() const { return structure_; }

  /// Changes with each clear().
  std::uint64_t epoch() const { return epoch_; }

  /// From this stamp on each edge had the parent that it has now.
  std::int64_t settled() const { return settled_; }

 private:
  friend class TfExcerpt;  // fills a buffer edge by edge, with the names of another one

  struct Edge {
    std::uint64_t message = 0;  ///< the last one with this edge
    std::int64_t received = 0;
    std::int64_t newest = 0;
    Frame parent = 0;
    bool is_met = false;  ///< see isMet()
    bool has_parent = false;
    bool is_static = false;
    bool is_distrusted = false;          ///< see distrustStampsAhead()
    std::optional<EdgeHistory> history;  ///< none before the first transform

    void clear();
  };

  /// A step of a climb.
  struct Step {
    Frame frame;
    Tf2Pose frame_from_source;
  };

  const char* insert(const TransformView& transform, bool is_static, std::int64_t now);
  void record(Edge& edge, Frame parent, std::int64_t stamp);
  bool isTooOld(Frame child, std::int64_t stamp) const;
  const char* refuse(Frame child, std::int64_t stamp, std::int64_t now);
  bool climb(Frame source, Frame target, std::int64_t stamp) const;

  FrameNames names_;
  std::vector<Edge> edges_;  ///< by child
  TfIntake intake_;
  std::uint64_t message_ = 1;
  std::uint64_t structure_ = 1;
  std::uint64_t epoch_ = 1;
  std::int64_t settled_ = 0;
  mutable std::vector<Step> steps_;  ///< the last climb, from the source upwards
  mutable WalkMarks marks_;          ///< places in steps_
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All transforms of the last ten seconds, in one table of edges.
//
// tf2::BufferCore keeps the same transforms. It cannot tell when a transform was received, which
// decides about stale frames, or which edges a message changed, which decides about recomputing
// boxes; it cannot forget a single edge; and it prints a line for each transform that it refuses.
#pragma once

#include <ros/time.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "world/tf/edge_history.h"
#include "world/tf/frame_names.h"
#include "world/tf/tf_message.h"
#include "world/tf/walk_marks.h"

namespace link_bounds {

/// A transform that was not accepted, that came late, or whose edge is in doubt.
struct Refusal {
  std::size_t index;               ///< its place in the message
  const char* reason;              ///< with the remedy
  std::optional<double> behind{};  ///< seconds behind the newest stamp, if it is late or too old
  bool is_accepted = false;  ///< added to the history; if late, it is not the newest transform
};

/// How many transforms were accepted and refused since the start.
struct TfIntake {
  std::uint64_t accepted = 0;
  std::uint64_t late = 0;      ///< accepted with a stamp before the newest one of their frame
  std::uint64_t repeated = 0;  ///< refused: the history has that stamp already
  std::uint64_t other = 0;     ///< repeated with another pose or parent
  std::uint64_t too_old = 0;   ///< refused
  std::uint64_t unusable = 0;  ///< refused: see whyRefused
  std::uint64_t dropped = 0;   ///< refused: sent before the clock jumped
  std::uint64_t replaced = 0;  ///< accepted: another value of a static transform
};

/// An edge leads from a child frame to its parent. Functions identify an edge by its child. Times
/// are nanoseconds of ROS time.
class TransformBuffer {
 public:
  using Frame = FrameNames::Frame;

  TransformBuffer() = default;
  TransformBuffer(const TransformBuffer&) = delete;
  TransformBuffer& operator=(const TransformBuffer&) = delete;

  /// A number for the name, which never changes. The frame is never forgotten.
  Frame frame(std::string_view name);

  /// Keeps a frame from being forgotten as long as this object lives.
  class Hold {
   public:
    Hold() = default;
    Hold(TransformBuffer& tf, std::string_view name) : tf_(&tf), frame_(tf.frame(name)) {}
    Hold(Hold&& other) noexcept : tf_(std::exchange(other.tf_, nullptr)), frame_(other.frame_) {}
    Hold& operator=(Hold&& other) noexcept {
      std::swap(tf_, other.tf_);
      std::swap(frame_, other.frame_);
      return *this;
    }
    ~Hold() {
      if (tf_) --tf_->edges_[frame_].holds;
    }

    Frame frame() const { return frame_; }

   private:
    TransformBuffer* tf_ = nullptr;
    Frame frame_ = 0;
  };

  /// For a reader of frame numbers and names on another thread. As long as the result lives, no
  /// number or name that it may read is reused.
  std::shared_ptr<void> addReader() const {
    ++*readers_;
    return {nullptr, [count = readers_](void*) { --*count; }};
  }

  /// To be called every tick. While there are more than `kept` frames, forgets frames that nobody
  /// holds or watches and that had no transform for one to two minutes of steady time, except the
  /// first `kept` static ones. A call looks at about 1000 edges and samples.
  void forgetQuiet(ros::SteadyTime now, std::size_t kept = kKeptFrames);

  /// Enough for any robot and its surroundings.
  static constexpr std::size_t kKeptFrames = 10000;

  /// The number of frames that are not forgotten.
  std::size_t inUse() const { return edges_.size() - unused_; }

  /// The number of the name, as frame() gives it. Nothing for an unknown name, which is not added.
  std::optional<Frame> find(std::string_view name) const { return names_.known(name); }

  const std::string& name(Frame frame) const { return names_.name(frame); }

  /// All numbers of frames are below this.
  std::size_t size() const { return edges_.size(); }

  /// Adds the transforms of one message, received at `now`. Returns the ones to report. Repeated
  /// stamps, and late stamps of max 1 s on an edge that got its newest stamp within the last 1 s,
  /// are only counted.
  std::vector<Refusal> add(const std::vector<TransformView>& transforms, bool is_static,
                           ros::Time now);

  /// As tf2's lookupTransform(target, source, stamp): by the edges as they were at that time,
  /// interpolated; at time 0 the newest of each edge. Nothing if a history does not reach the time,
  /// or if the way up from the source runs into a loop before it meets the target. A frame in
  /// itself needs no transform. The result may not be finite.
  std::optional<Tf2Pose> pose(Frame target, Frame source, std::int64_t stamp) const;

  /// Forgets everything that is not static, after a clock jump.
  void clear();

  /// Counts a transform that was sent before a clock jump, instead of add().
  void countDropped(const TransformView& transform);

  /// Lets edges recover whose newest stamp is more than 10 s ahead of `now`, so that tf refuses all
  /// stamps of correct clocks: the next transform that is too old replaces the edge's history.
  void distrustStampsAhead(ros::Time now);

  /// Edges received before the clock ran count as received now.
  void startClock(ros::Time now);

  /// The clock jumped ahead, see ClockWatch. A transform from after the jump may have come before
  /// the new time. So an edge whose newest stamp differs from `now` by max 0.5 s counts as received
  /// now. True if there is such an edge.
  bool jumpAhead(ros::Time now);

  const TfIntake& intake() const { return intake_; }

  /// As intake(), but only for needed edges; `accepted` is not counted.
  const TfIntake& neededIntake() const { return needed_intake_; }

  /// The edge is needed until release(), because a followed pose depends on it. After a clear() it
  /// stays needed until a transform of it is accepted.
  void need(Frame child) { ++edges_[child].needs; }
  void release(Frame child) { --edges_[child].needs; }

  /// The max delay from stamp to arrival [ns] of the newest transforms of needed edges since the
  /// last call; nothing if none came.
  std::optional<std::int64_t> takeMaxLag() { return std::exchange(max_lag_, std::nullopt); }

  /// True if a message after that version() had this edge.
  bool isNewerThan(std::uint64_t version, Frame child) const {
    return edges_[child].message > version;
  }

  /// True once an accepted transform had the frame, as child or as parent.
  bool isMet(Frame frame) const { return edges_[frame].is_met; }

  /// False at the top of a tree.
  bool hasParent(Frame child) const { return edges_[child].has_parent; }

  /// The parent in the newest transform. There must be one.
  Frame parent(Frame child) const { return edges_[child].parent; }

  /// Decided by the first transform, as in tf2.
  bool isStatic(Frame child) const { return edges_[child].is_static; }

  /// A static edge is in doubt once /tf sends it with another pose, until /tf_static sends it more
  /// than 10 s after the last such pose. tf2 uses the newest pose for all times, but the frame may
  /// move.
  bool isStaticInDoubt(Frame child) const { return edges_[child].is_in_doubt; }

  /// The newest stamp; 0 if the edge is static or has no transform.
  std::int64_t newest(Frame child) const { return edges_[child].newest; }

  /// When the transform with the newest stamp was accepted. Late transforms do not count.
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

  /// From now on structure() changes when this edge's parent changes; edges that nobody watches do
  /// not count. To be repeated with each forgetQuiet(), so that the frame is not forgotten.
  void watch(Frame child) { edges_[child].watched = pass_; }

  /// Changes whenever a watched edge may lead to another parent, now or in the past.
  std::uint64_t structure() const { return structure_; }

  /// Changes with each clear().
  std::uint64_t epoch() const { return epoch_; }

  /// At this stamp and all later ones, each edge had its current parent.
  std::int64_t settled() const { return settled_; }

 private:
  friend class TfExcerpt;  // fills a copy edge by edge, with the names of the original

  struct Edge {
    std::uint64_t message = 0;  ///< version() at the last accepted transform or jumpAhead()
    std::int64_t received = 0;
    std::int64_t newest = 0;
    Frame parent = 0;
    std::uint64_t watched = 0;     ///< pass of the last watch(); 0: never
    std::uint64_t referenced = 0;  ///< last pass that saw an edge from another frame
    std::uint32_t holds = 0;
    std::uint32_t needs = 0;
    bool was_needed = false;  ///< at the last clear(), until a transform is accepted
    bool is_met = false;      ///< see isMet()
    bool has_parent = false;
    bool is_static = false;
    bool is_in_doubt = false;            ///< see isStaticInDoubt()
    std::int64_t doubted = 0;            ///< when /tf last sent another pose
    bool is_kept = false;                ///< static, and never forgotten
    bool is_distrusted = false;          ///< see distrustStampsAhead()
    bool had_others = false;             ///< the history may have other parents, too
    bool is_unused = false;              ///< the frame was forgotten
    std::optional<EdgeHistory> history;  ///< none before the first transform

    void clear();
    bool isNeeded() const { return needs > 0 || was_needed; }
    void doubt(bool is_replaced, bool on_static, std::int64_t now);
    bool isTooOld(std::int64_t stamp) const { return stamp + EdgeHistory::kLength < newest; }
  };

  /// A frame on the way up from the source in climb().
  struct Step {
    Frame frame;
    Tf2Pose frame_from_source;
  };

  bool insert(const TransformView& transform, bool is_static, std::int64_t now, Refusal& refusal);
  static bool insert(Edge& edge, std::int64_t stamp, Frame parent, const Tf2Pose& pose);
  bool record(Edge& edge, Frame parent, std::int64_t stamp, std::int64_t now);
  bool refuse(const Edge& edge, const EdgeSample& sample);
  void count(std::uint64_t TfIntake::*what, bool is_needed);
  void countByName(std::uint64_t TfIntake::*what, std::string_view child);
  void adoptNumber(Frame frame);
  std::size_t visit(Frame frame, std::size_t kept_static);
  std::size_t reference(Frame frame);
  void endPass();
  bool climb(Frame source, Frame target, std::int64_t stamp) const;

  FrameNames names_;
  std::vector<Edge> edges_;  ///< by child
  TfIntake intake_;
  TfIntake needed_intake_;
  std::optional<std::int64_t> max_lag_;
  std::uint64_t message_ = 1;
  std::uint64_t structure_ = 1;
  std::uint64_t epoch_ = 1;
  std::int64_t settled_ = 0;
  std::uint64_t pass_ = 1;  ///< of forgetQuiet() over all frames: the number of the current one
  Frame next_ = 0;          ///< the next frame that this pass visits
  std::size_t kept_static_ = 0;      ///< edges that are kept because they are static
  std::size_t unused_ = 0;           ///< frames that were forgotten and whose numbers are free
  ros::SteadyTime noted_at_;         ///< start of the current minute
  std::uint64_t noted_message_ = 0;  ///< message_ at noted_at_
  std::uint64_t quiet_since_ = 0;    ///< message_ at the start of the last full minute
  std::vector<Frame> forgotten_;     ///< frames whose names were forgotten, until a later pass ends
  std::vector<Frame> waiting_;       ///< forgotten before: reusable after all readers_before_ ended
  std::shared_ptr<std::atomic<int>> readers_ = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<std::atomic<int>> readers_before_ = std::make_shared<std::atomic<int>>(0);
  mutable std::vector<Step> steps_;  ///< result of climb(), from the source upwards
  mutable WalkMarks marks_;          ///< indices in steps_
};

}  // namespace link_bounds

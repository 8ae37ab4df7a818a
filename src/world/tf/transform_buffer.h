// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All transforms of the last ten seconds, in one table of edges.
//
// tf2::BufferCore keeps the same transforms. It cannot say when one was received or which edges a
// message touched, which decides about recomputing boxes and about stale frames; it cannot forget
// a single edge; and it prints a line for each transform that it refuses.
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
  std::optional<double> behind{};  ///< the newest stamp of its frame [s], if that is the reason
  bool is_accepted = false;        ///< into the history; of a late one, the newest transform stays
};

/// How many transforms were accepted and refused since the start.
struct TfIntake {
  std::uint64_t accepted = 0;
  std::uint64_t late = 0;      ///< accepted with a stamp before the newest one of their frame
  std::uint64_t repeated = 0;  ///< refused: there is one of that stamp already
  std::uint64_t other = 0;     ///< of those, with another pose or parent
  std::uint64_t too_old = 0;   ///< refused
  std::uint64_t unusable = 0;  ///< refused: see whyRefused
  std::uint64_t dropped = 0;   ///< refused: sent before the clock jumped
  std::uint64_t replaced = 0;  ///< accepted: another value of a static transform
};

/// An edge leads from a frame to its parent and is named by the frame, the child. Times are
/// nanoseconds of ROS time.
class TransformBuffer {
 public:
  using Frame = FrameNames::Frame;

  TransformBuffer() = default;
  TransformBuffer(const TransformBuffer&) = delete;
  TransformBuffer& operator=(const TransformBuffer&) = delete;

  /// A number for the name, which never changes. The frame is never forgotten.
  Frame frame(std::string_view name);

  /// A frame that is not forgotten as long as this lives.
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

  /// Counts those who read numbers and names of frames on other threads: what they read stays.
  class Readers {
   public:
    Readers() = default;
    explicit Readers(const TransformBuffer& tf) : count_(tf.readers_) { ++*count_; }
    Readers(Readers&&) = default;
    Readers& operator=(Readers&& other) noexcept {
      std::swap(count_, other.count_);
      return *this;
    }
    ~Readers() {
      if (count_) --*count_;
    }

   private:
    std::shared_ptr<std::atomic<int>> count_;
  };

  /// To be called every tick. Of more than `kept` frames, forgets those that nobody holds or
  /// watches and that had no transform for a minute of steady time, or two; but not the first
  /// `kept` static ones. Looks at some hundred frames.
  void forgetQuiet(ros::SteadyTime now, std::size_t kept = kKeptFrames);

  /// Enough for any robot and its surroundings.
  static constexpr std::size_t kKeptFrames = 10000;

  /// The number of frames that are not forgotten.
  std::size_t inUse() const { return edges_.size() - unused_; }

  /// The number of the name, as frame() gives it. Nothing for an unknown name, which stays unknown.
  std::optional<Frame> find(std::string_view name) const { return names_.known(name); }

  const std::string& name(Frame frame) const { return names_.name(frame); }

  /// All numbers of frames are below this.
  std::size_t size() const { return edges_.size(); }

  /// Adds the transforms of one message, received at `now`. Refused ones change nothing. Repeated
  /// stamps, and those at most 1 s behind on an edge that still receives newer ones, are counted
  /// but not reported.
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

  /// An edge whose newest stamp is so far ahead of `now` that tf refuses all stamps of correct
  /// clocks may begin again: the next transform that is too old replaces its history.
  void distrustStampsAhead(ros::Time now);

  /// Edges received before the clock ran count as received now.
  void startClock(ros::Time now);

  /// The clock jumped ahead, see ClockWatch. A transform from after the jump may have come before
  /// the new time did: an edge whose newest stamp is within half a second of it counts as received
  /// now. True if there is one.
  bool jumpAhead(ros::Time now);

  const TfIntake& intake() const { return intake_; }

  /// The same of needed edges alone.
  const TfIntake& neededIntake() const { return needed_intake_; }

  /// A pose that somebody follows comes from this edge, until release(). After a clear() the edge
  /// counts as needed until a transform of it is accepted.
  void need(Frame child) { ++edges_[child].needs; }
  void release(Frame child) { --edges_[child].needs; }

  /// By how much the newest transforms of needed edges came behind their stamps [ns], the maximum
  /// since the last call; nothing if none came.
  std::optional<std::int64_t> takeMaxLag() { return std::exchange(max_lag_, std::nullopt); }

  /// True if a message had this edge after the buffer had that version.
  bool isNewerThan(std::uint64_t version, Frame child) const {
    return edges_[child].message > version;
  }

  /// True once an accepted transform had the frame, as child or as parent.
  bool isMet(Frame frame) const { return edges_[frame].is_met; }

  /// False at the top of a tree.
  bool hasParent(Frame child) const { return edges_[child].has_parent; }

  /// By the newest transform. There must be one.
  Frame parent(Frame child) const { return edges_[child].parent; }

  /// Decided by the first transform, as in tf2.
  bool isStatic(Frame child) const { return edges_[child].is_static; }

  /// A static edge that has come on /tf with another pose, up to a /tf_static that comes 10 s or
  /// more after the last such pose. tf2 has it at its newest pose at all times, but it may move.
  bool isStaticInDoubt(Frame child) const { return edges_[child].is_in_doubt; }

  /// The newest stamp; 0 if the edge is static or has no transform.
  std::int64_t newest(Frame child) const { return edges_[child].newest; }

  /// When the newest stamp was accepted. What comes late does not count.
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

  /// From now on structure() counts changes of this edge. Where others change, nobody looked. To be
  /// repeated with each forgetQuiet(), so that the frame is not forgotten.
  void watch(Frame child) { edges_[child].watched = pass_; }

  /// Changes whenever a watched edge may lead to another parent, now or in the past.
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
    std::uint64_t watched = 0;     ///< pass of the last watch(); 0: never
    std::uint64_t referenced = 0;  ///< pass in which another edge was seen that leads here
    std::uint32_t holds = 0;
    std::uint32_t needs = 0;
    bool was_needed = false;  ///< before a clear(), since when no transform was accepted
    bool is_met = false;      ///< see isMet()
    bool has_parent = false;
    bool is_static = false;
    bool is_in_doubt = false;            ///< see isStaticInDoubt()
    std::int64_t doubted = 0;            ///< when it last came on /tf with another pose
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

  /// A step of a climb.
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
  std::uint64_t pass_ = 1;           ///< over all frames: this and what follows is of forgetQuiet()
  Frame next_ = 0;                   ///< to be visited
  std::size_t kept_static_ = 0;      ///< edges that are kept because they are static
  std::size_t unused_ = 0;           ///< frames that were forgotten and whose numbers are free
  ros::SteadyTime noted_at_;         ///< a minute ago, or less
  std::uint64_t noted_message_ = 0;  ///< at that time
  std::uint64_t quiet_since_ = 0;    ///< the message before the last full minute
  std::vector<Frame> forgotten_;     ///< in this pass
  std::vector<Frame> waiting_;       ///< in an earlier pass: until readers_before_ have ended
  std::shared_ptr<std::atomic<int>> readers_ = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<std::atomic<int>> readers_before_ = std::make_shared<std::atomic<int>>(0);
  mutable std::vector<Step> steps_;  ///< the last climb, from the source upwards
  mutable WalkMarks marks_;          ///< places in steps_
};

}  // namespace link_bounds

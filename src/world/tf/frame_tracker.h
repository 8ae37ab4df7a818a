// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of followed frames in the fixed frame, each at the latest common time of its own path.
//
// Seen from the fixed frame, the paths are a tree that grows outward. Nearly always a frame has the
// same time as the previous frame of its path. Its pose is then the previous pose times one edge or
// the inverse of an edge. Otherwise the complete path is read.
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "world/tf/transform_buffer.h"
#include "world/tf/transform_problem.h"

namespace link_bounds {

/// The pose of a followed frame in the fixed frame.
struct FramePose {
  TransformProblem problem = TransformProblem::kNoTransform;  ///< kNoTransform, kStale or kNone
  bool is_changed = false;  ///< the last update changed the problem, stamp or pose
  bool has_moved = false;   ///< the last update changed the pose
  std::int64_t stamp = 0;   ///< nanoseconds; latest common time of the path, 0 if it is all static
  MatrixPose fixed_from_frame;

  void setChanged(TransformProblem old_problem, std::int64_t old_stamp) {
    is_changed = problem != old_problem ||
                 (problem == TransformProblem::kNone && (has_moved || stamp != old_stamp));
  }
};

class FrameTracker {
 public:
  using Frame = TransformBuffer::Frame;

  /// The frame is followed as long as one of its handles lives.
  class Handle {
   public:
    Handle() = default;
    Handle(Handle&& other) noexcept
        : tracker_(std::exchange(other.tracker_, nullptr)), frame_(other.frame_) {}
    Handle& operator=(Handle&& other) noexcept {
      std::swap(tracker_, other.tracker_);
      std::swap(frame_, other.frame_);
      return *this;
    }
    ~Handle() {
      if (tracker_) tracker_->release(frame_);
    }

    explicit operator bool() const { return tracker_ != nullptr; }
    const FramePose& pose() const { return tracker_->pose(frame_); }

   private:
    friend class FrameTracker;
    Handle(FrameTracker& tracker, Frame frame) : tracker_(&tracker), frame_(frame) {}

    FrameTracker* tracker_ = nullptr;
    Frame frame_ = 0;
  };

  explicit FrameTracker(TransformBuffer& tf) : tf_(tf), nodes_(1, rootNode()) {}
  FrameTracker(const FrameTracker&) = delete;
  FrameTracker& operator=(const FrameTracker&) = delete;
  ~FrameTracker() { release(nodes_); }

  /// Starts over with another fixed frame. A pose is stale if an edge of its path got no newer
  /// stamp for longer than `timeout` [ROS s]; 0 = never. Before the first call no frame has a pose.
  void setTarget(Frame fixed_frame, double timeout, ros::Time now);
  void setTarget(std::string_view fixed_frame, double timeout, ros::Time now) {
    setTarget(tf_.frame(fixed_frame), timeout, now);
  }

  /// Nothing before the first setTarget().
  std::optional<Frame> fixedFrame() const { return fixed_frame_; }
  double timeout() const { return timeout_; }

  /// Starts to follow a frame. Its pose is available at once if tf knows it.
  Handle follow(Frame frame);
  Handle follow(std::string_view name) { return follow(tf_.frame(name)); }

  /// Follows the frame as long as the tracker lives. The reference is valid until the next call
  /// that follows a frame, sets the target or updates.
  const FramePose& keep(Frame frame) {
    Handle handle = follow(frame);
    handle.tracker_ = nullptr;
    return pose(frame);
  }

  /// To be called after tf received one or more messages.
  void update(ros::Time now);

  /// Computes everything again, as is needed after tf was cleared.
  void updateAll(ros::Time now);

  /// Finds poses that have become stale.
  void expire(ros::Time now);

  TransformBuffer& tf() { return tf_; }
  const TransformBuffer& tf() const { return tf_; }

 private:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

  /// How the edge of a node leads outward: from parent to child, from child to parent, from the
  /// fixed frame to itself, or not at all.
  enum class Step : std::uint8_t { kAlong, kAgainst, kStay, kNone };
  static bool isMade(Step step) { return step == Step::kAlong || step == Step::kAgainst; }

  /// A frame on the path from the fixed frame to a followed frame.
  struct Node : FramePose {
    bool is_news = false;   ///< an edge of its path was received since the last update
    bool has_pose = false;  ///< the histories cover its stamp
    Step step = Step::kNone;
    bool is_static = true;           ///< the complete path is
    bool is_below = true;            ///< the way up from this frame meets the fixed frame
    bool was_elsewhere = false;      ///< walk() read the pose along the complete path
    std::int64_t received = kNever;  ///< the min of the path's edges that are not static
    Frame frame = 0;
    Frame edge = 0;
    std::size_t inner = 0;  ///< place of the previous node of the path
  };

  /// How a frame is followed.
  struct Followed {
    std::size_t handles = 0;
    std::size_t place = kNowhere;  ///< index in nodes_; may remain for some time without handles
  };

  /// A followed frame and its index in nodes_ before a build.
  struct Place {
    Frame frame;
    std::size_t old_place;
  };

  static Node rootNode();
  const FramePose& pose(Frame frame) const { return nodes_[followed_[frame].place]; }
  void release(Frame frame);
  void release(const std::vector<Node>& nodes);

  std::vector<Place> takePlaces(const std::vector<Node>& nodes);
  void watch(Frame frame);
  void build(const std::vector<Place>& places);
  void findAbove();
  std::size_t add(Frame frame);
  std::size_t addPath(Frame frame);
  std::size_t addAbove(std::size_t height);
  std::size_t append(std::size_t inner, Frame frame, Frame edge, Step step);
  void place(Node& node);
  bool compose(Node& node);
  bool invert(Node& node, const EdgeSample& edge);
  bool walk(Node& node) const;
  void setReceived(Node& node) const;

  TransformBuffer& tf_;
  std::optional<Frame> fixed_frame_;
  double timeout_ = 0;
  std::int64_t stale_before_ = 0;  ///< nanoseconds of ROS time
  std::vector<Followed> followed_;
  std::size_t unused_ = 0;    ///< frames without handles that still have a place
  std::vector<Node> nodes_;   ///< the fixed frame, then each node after its `inner`
  WalkMarks marks_;           ///< indices in nodes_; kNowhere: no path to the fixed frame
  std::vector<Frame> above_;  ///< the fixed frame and its ancestors, see findAbove()
  std::vector<Tf2Pose> above_from_fixed_;  ///< poses of the fixed frame; unset if was_elsewhere
  WalkMarks heights_;                      ///< indices in above_
  std::vector<Frame> watched_;             ///< frames watched since the tree was built
  std::vector<Frame> way_;                 ///< the way up from one frame; kept to reuse its memory
  std::uint64_t structure_ = 0;            ///< structure() of tf when the tree was built
  std::uint64_t seen_ = 0;                 ///< version of tf at the last update
};

/// The older of two stamps of transforms [ns]. A stamp of 0, which static transforms have, is
/// ignored.
std::int64_t olderStamp(std::int64_t a, std::int64_t b);

/// Edges received before the returned time [ns of ROS time] are stale at `now`. `timeout` is in
/// seconds; 0: no edge is ever stale.
std::int64_t staleBefore(double timeout, ros::Time now);

}  // namespace link_bounds

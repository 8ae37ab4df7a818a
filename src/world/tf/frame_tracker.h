// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of followed frames in the fixed frame, each at the latest common time of its own path.
//
// Seen from the fixed frame the paths are a tree that grows outward, against the direction of some
// edges. Nearly everywhere a frame has the same time as the frame before it, and its pose is that
// one's times a single edge. Only elsewhere its complete path is read.
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "world/tf/transform_buffer.h"
#include "world/tf/transform_problem.h"

namespace link_bounds {

/// A followed frame.
struct FramePose {
  TransformProblem problem = TransformProblem::kNoTransform;  ///< that, kStale or kNone
  bool is_changed = false;  ///< problem, stamp or pose is another one than before the last update
  bool has_moved = false;   ///< the pose is
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

  /// The pose is there at once, if tf knows it.
  Handle follow(Frame frame);
  Handle follow(std::string_view name) { return follow(tf_.frame(name)); }

  /// Follows the frame as long as this lives. The reference is valid until the next frame comes.
  const FramePose& keep(Frame frame) {
    Handle handle = follow(frame);
    handle.tracker_ = nullptr;
    return pose(frame);
  }

  /// To be called after one message or several.
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

  /// A frame on the path of one that is followed.
  struct Node : FramePose {
    bool is_news = false;   ///< an edge of its path was received since the last update
    bool has_pose = false;  ///< the histories reach its time
    Step step = Step::kNone;
    bool is_static = true;           ///< the complete path
    bool is_below = true;            ///< the fixed frame is on its way up
    bool was_elsewhere = false;      ///< the pose was read along a path of its own
    std::int64_t received = kNever;  ///< of the oldest edge of the path that is not static
    Frame frame = 0;
    Frame edge = 0;
    std::size_t inner = 0;  ///< the node before this one
  };

  /// By frame.
  struct Followed {
    std::size_t handles = 0;
    std::size_t place = kNowhere;  ///< in nodes_; may remain for some time without handles
  };

  /// A followed frame and its place before a build.
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
  std::vector<Node> nodes_;   ///< the fixed frame, then each after the one before it
  WalkMarks marks_;           ///< places in nodes_; kNowhere: has no path to the fixed frame
  std::vector<Frame> above_;  ///< the fixed frame and those above it, without a loop
  std::vector<Tf2Pose> above_from_fixed_;  ///< where their nodes are not elsewhere
  WalkMarks heights_;                      ///< places in above_
  std::vector<Frame> watched_;             ///< since the tree was built
  std::vector<Frame> way_;                 ///< of one frame, upwards; kept for its memory
  std::uint64_t structure_ = 0;            ///< of tf, when the tree was built
  std::uint64_t seen_ = 0;                 ///< version of tf at the last update
};

/// The older of two stamps of transforms [ns]; 0, that of a static one, does not count.
std::int64_t olderStamp(std::int64_t a, std::int64_t b);

/// What was received before this [ns of ROS time] is stale at `now`. `timeout` in seconds, 0:
/// never.
std::int64_t staleBefore(double timeout, ros::Time now);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of many frames in one fixed frame, each at the latest common time of its own path.
//
// Seen from the fixed frame the paths are a tree that grows outward, against the direction of some
// edges. Nearly everywhere a frame has the same time as the frame before it, and its pose is that
// one's times a single edge; only elsewhere is its whole path read.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "node/tf/transform_source.h"

namespace link_bounds {

class PoseTree {
 public:
  using Frame = FrameTree::Frame;
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

  /// A frame on the path of one that is followed.
  struct Node {
    bool is_news = true;     ///< an edge of its path was heard in the last message, or it is new
    bool has_pose = false;   ///< the histories reach its time
    bool has_moved = false;  ///< another pose than before

   private:
    friend class PoseTree;
    enum class Step : std::uint8_t { kAlong, kAgainst, kStay };

    Step step = Step::kStay;     ///< how the edge is used, outward
    bool is_static = true;       ///< the whole path
    bool is_below = true;        ///< the fixed frame is on its way up
    bool was_elsewhere = false;  ///< the pose was read along a path of its own

   public:
    std::int64_t stamp = 0;  ///< nanoseconds; latest common time of the path, 0 if it is all static
    std::int64_t heard = kNever;  ///< when the oldest edge of the path that is not static was heard
    MatrixPose fixed_from_frame;

   private:
    Frame frame = 0;
    Frame edge = 0;
    std::size_t inner = 0;  ///< the node before this one
  };

  /// Starts over with these frames; they have poses from the next updateAll() on.
  void follow(Frame fixed_frame, std::vector<Frame> frames);

  /// To be called after each message.
  void update(const TransformSource& tf);

  /// Reads everything anew, as is needed after tf was cleared.
  void updateAll(const TransformSource& tf);

  /// Ages only.
  void updateHeard(const FrameTree& tree);

  /// Of the i-th frame; null if tf does not connect it with the fixed frame.
  const Node* node(std::size_t i) const {
    return places_[i] == kNowhere ? nullptr : &nodes_[places_[i]];
  }

  /// True if the last update brought new paths, or may have taken some away.
  bool isRebuilt() const { return is_rebuilt_; }

 private:
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

  void build(const FrameTree& tree);
  void findAbove(const FrameTree& tree);
  std::size_t addPath(Frame frame, const FrameTree& tree);
  std::size_t addAbove(std::size_t height);
  std::size_t append(std::size_t inner, Frame frame, Frame edge, Node::Step step);
  void place(Node& node, const TransformSource& tf);
  bool compose(Node& node, const TransformSource& tf);
  bool invert(Node& node, const EdgeSample& edge);
  bool walk(Node& node, const TransformSource& tf) const;
  void hear(Node& node, const FrameTree& tree) const;

  Frame fixed_frame_ = 0;
  std::vector<Frame> frames_;
  std::vector<std::size_t> places_;  ///< of the frames in nodes_
  std::vector<Node> nodes_;          ///< the fixed frame, then each after the one before it
  WalkMarks marks_;                  ///< places in nodes_; kNowhere: has no path to the fixed frame
  std::vector<Frame> above_;         ///< the fixed frame and those above it, if no loop is there
  std::vector<Tf2Pose> above_from_fixed_;  ///< where their nodes are not elsewhere
  WalkMarks heights_;                      ///< places in above_
  std::vector<Frame> way_;                 ///< of one frame, upwards; kept for its memory
  std::uint64_t structure_ = 0;
  bool is_rebuilt_ = false;
};

}  // namespace link_bounds

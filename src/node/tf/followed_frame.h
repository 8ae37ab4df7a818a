// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One frame and its pose in the fixed frame, looked up again where tf brought news.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "node/tf/transform_source.h"

namespace link_bounds {

class FollowedFrame {
 public:
  using Frame = FrameTree::Frame;
  enum class Trouble { kNone, kNoTransform, kStale };

  /// What all frames of one node have in common.
  struct Target {
    Frame fixed_frame = 0;
    double timeout = 0;  ///< ROS seconds, see the parameter; 0 = never stale
  };

  explicit FollowedFrame(Frame frame) : frame_(frame) {}

  /// To be called after each tf message. `paths_may_differ` if the structure of the tree changed.
  /// True if pose, stamp or trouble changed.
  bool update(const Target& target, const TransformSource& tf, ros::Time now,
              bool paths_may_differ);

  /// Looks everything up anew; true as above.
  bool refresh(const Target& target, const TransformSource& tf, ros::Time now);

  /// True if the frame has become stale.
  bool expire(const Target& target, const TransformSource& tf, ros::Time now);

  Trouble trouble() const { return trouble_; }

  /// World from frame; meaningful without trouble.
  const StampedPose& pose() const { return pose_; }

 private:
  bool findPath(const Target& target, const FrameTree& tree);
  bool isTouched(const FrameTree& tree) const;
  bool isStale(const Target& target, const FrameTree& tree, ros::Time now) const;
  bool lookUp(const Target& target, const TransformSource& tf, ros::Time now);

  Frame frame_;
  std::optional<std::vector<Frame>> path_;  ///< edges from the frame to the fixed frame
  bool was_elsewhere_ = false;  ///< at the time of the pose the path may have been another one
  Trouble trouble_ = Trouble::kNoTransform;
  StampedPose pose_{Eigen::Isometry3d::Identity(), 0};
};

}  // namespace link_bounds

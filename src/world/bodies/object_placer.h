// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where objects are in the fixed frame: they follow their header frame, or stay where they were
// placed once.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "world/bodies/live_object.h"

namespace link_bounds {

struct ObjectPose {
  TransformProblem problem = TransformProblem::kNoTransform;
  /// Without a problem, or where an object waits that was placed earlier.
  std::optional<Eigen::Affine3d> fixed_from_header = std::nullopt;
  std::int64_t stamp = 0;  ///< of the box [ns], if there is a pose
};

class ObjectPlacer {
 public:
  using Frame = FrameTracker::Frame;

  explicit ObjectPlacer(FrameTracker& frames) : frames_(frames) {}
  ObjectPlacer(const ObjectPlacer&) = delete;
  ObjectPlacer& operator=(const ObjectPlacer&) = delete;

  /// Where the object is. There must be a fixed frame. Places an object that is placed once as soon
  /// as there is a transform at its stamp.
  ObjectPose place(LiveObject& object, ros::Time now);

  /// Objects that were placed in these frames are carried over to the present fixed frame, each by
  /// the first transform between the two frames that is good.
  void carryFrom(const std::vector<Frame>& old_fixed_frames);

  /// To be called after each update of the poses. True if there is a new transform for carrying.
  bool findCarries();

  /// True if this is too long to wait for the transform at a stamp.
  bool hasWaitedLong(std::int64_t since, ros::Time now) const;

 private:
  /// From an old fixed frame; followed until there is a pose, which then stays.
  struct Carry {
    FrameTracker::Handle old_frame;
    std::optional<Eigen::Affine3d> fixed_from_old;
  };

  /// What tf last said of a frame at a time. Many objects of one message have it in common: without
  /// it each walks the same path, for each message of tf while they wait.
  struct PastPose {
    Frame fixed_frame;
    Frame frame;
    std::int64_t stamp;
    std::uint64_t tf_version;
    std::optional<Eigen::Affine3d> fixed_from_frame;
  };

  TransformProblem placeOnce(LiveObject& object, ros::Time now);
  bool knowsTimeOf(const LiveObject& object);
  std::optional<Eigen::Affine3d> poseAt(std::int64_t stamp, Frame frame);
  std::optional<Eigen::Affine3d> carried(const ObjectPlacement& placement) const;

  FrameTracker& frames_;
  std::map<Frame, Carry> carries_;  ///< by old fixed frame
  std::optional<PastPose> past_pose_;
};

}  // namespace link_bounds

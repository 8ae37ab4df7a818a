// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of objects in the fixed frame: they follow their header frame, or stay where they were
// placed once.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "world/bodies/live_object.h"

namespace link_bounds {

struct ObjectPose {
  TransformProblem problem = TransformProblem::kNoTransform;
  /// Set if there is no problem, or if the object waits at an earlier placement.
  std::optional<Eigen::Affine3d> fixed_from_header = std::nullopt;
  std::int64_t stamp = 0;  ///< of the box [ns], if there is a pose
};

class ObjectPlacer {
 public:
  using Frame = FrameTracker::Frame;

  explicit ObjectPlacer(FrameTracker& frames) : frames_(frames) {}
  ObjectPlacer(const ObjectPlacer&) = delete;
  ObjectPlacer& operator=(const ObjectPlacer&) = delete;

  /// The object's pose. There must be a fixed frame. An object that is placed once is placed by the
  /// first call at which tf has a transform at its stamp.
  ObjectPose place(LiveObject& object, ros::Time now);

  /// From now on, placements in these frames are transformed to the current fixed frame, by the
  /// first valid transform between the two frames.
  void carryFrom(const std::vector<Frame>& old_fixed_frames);

  /// To be called after each update of the poses. True if a transform from an old fixed frame was
  /// found.
  bool findCarries();

  /// Whether a wait since `since` [ns] for the transform at a stamp has become too long.
  bool hasWaitedLong(std::int64_t since, ros::Time now) const;

 private:
  /// The transform from an old fixed frame. That frame is followed until it has a pose, which is
  /// then kept.
  struct Carry {
    FrameTracker::Handle old_frame;
    std::optional<Eigen::Affine3d> fixed_from_old;
  };

  /// The last pose that was looked up in tf. Many objects of one message have the same frame and
  /// stamp: without this cache, each would read the same path for each tf message while it waits.
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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a scene with the axes of another frame.
#pragma once

#include <map>
#include <string>

#include "world/bodies/scene.h"

namespace link_bounds {

/// Each box is that of the body itself, not a box around the scene's box. Links, and objects that
/// follow a frame, are where tf has them in this frame; objects that were placed once move with the
/// scene's fixed frame.
class FrameView {
 public:
  /// Both must outlive this; the scene has a model.
  FrameView(const std::string& frame, Scene& scene, TransformBuffer& tf, ros::Time now);

  /// To be called after each message. True if a box of a link changed.
  bool update(ros::Time now);

  /// To be called with each tick. Likewise.
  bool expire(ros::Time now);

  TransformBuffer::Frame frame() const { return *frames_.fixedFrame(); }

  struct Placed {
    BoxState state;
    std::int64_t pose_stamp = 0;  ///< [ns], if there is a box; 0: it does not move
  };

  /// A body of the scene.
  Placed placed(const SceneBody& body);

 private:
  const FramePose& poseOf(const std::string& frame);

  Scene& scene_;
  FrameTracker frames_;
  LiveBoxes links_;
  struct Followed {
    TransformBuffer::Hold hold;  ///< while it is followed; the frame may be forgotten later
    FrameTracker::Handle handle;
  };
  std::map<std::string, Followed> followed_;  ///< of objects, and the fixed frame
};

}  // namespace link_bounds

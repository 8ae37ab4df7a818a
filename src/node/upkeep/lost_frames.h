// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings about frames that tf does not, or no longer, connect with the fixed frame.
#pragma once

#include <ros/time.h>

#include <string>
#include <vector>

#include "world/bodies/scene.h"
#include "world/log/loss_log.h"

namespace link_bounds {

class LostFrames {
 public:
  /// Call a few times per second. Returns the lines to log, by the rules of LossLog. If no link has
  /// a transform to the fixed frame: one line about that frame. Otherwise: one line about links,
  /// and one about header frames of objects.
  std::vector<std::string> warnings(Scene& scene, ros::SteadyTime now);

 private:
  LossLog fixed_frame_;
  LossLog links_;    ///< by name
  LossLog objects_;  ///< by header frame
};

}  // namespace link_bounds

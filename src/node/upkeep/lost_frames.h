// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings about frames that tf does not connect with the fixed frame, or no longer.
#pragma once

#include <ros/time.h>

#include <string>
#include <vector>

#include "world/bodies/scene.h"
#include "world/log/loss_log.h"

namespace link_bounds {

class LostFrames {
 public:
  /// To be called a few times per second. Returns the lines to log, by the rules of LossLog: one
  /// about the fixed frame, if no link has a transform to it; else one about links, one about
  /// header frames of objects.
  std::vector<std::string> warnings(Scene& scene, ros::SteadyTime now);

 private:
  LossLog fixed_frame_;
  LossLog links_;    ///< by name
  LossLog objects_;  ///< by header frame
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The motion of a robot whose joints all swing, as tf messages.
#pragma once

#include <tf2_msgs/TFMessage.h>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The joints that do not move.
tf2_msgs::TFMessage fixedTransforms(const Robot& robot);

/// The other joints at `time`, which is also the stamp. Each swings with its own phase.
tf2_msgs::TFMessage movingTransforms(const Robot& robot, ros::Time time);

}  // namespace link_bounds

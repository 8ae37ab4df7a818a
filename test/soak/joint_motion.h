// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot whose joints all swing, as messages of tf.
#pragma once

#include <tf2_msgs/TFMessage.h>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The joints that do not move.
tf2_msgs::TFMessage fixedTransforms(const Robot& robot);

/// The others, each swinging with a phase of its own; `time` and the stamp are the same.
tf2_msgs::TFMessage movingTransforms(const Robot& robot, ros::Time time);

}  // namespace link_bounds

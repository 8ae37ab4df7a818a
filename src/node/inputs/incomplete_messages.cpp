// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/inputs/incomplete_messages.h"

#include <ros/console.h>

namespace link_bounds {

const char* const kIncompleteMessage = "it is shorter than it says; correct its sender";

void IncompleteMessages::log(const std::string& topic, const std::string& sender) {
  const auto line = log_.line(topic, kIncompleteMessage, sender, ros::SteadyTime::now());
  if (line) ROS_WARN_STREAM(*line);
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot of load_testing.py: links link_0, link_1, ... in a row, each a child of base.
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <string>

namespace link_bounds {

constexpr double kLinkSpacing = 0.1;  // m
constexpr double kSwing = 0.03;       // m

/// All links at a phase of their swing [rad].
inline tf2_msgs::TFMessage swingingLinks(std::size_t links, double phase, ros::Time stamp) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(links);
  for (std::size_t i = 0; i < links; ++i) {
    geometry_msgs::TransformStamped& transform = message.transforms[i];
    const double angle = phase + static_cast<double>(i);
    transform.header.frame_id = "base";
    transform.header.stamp = stamp;
    transform.child_frame_id = "link_" + std::to_string(i);
    transform.transform.translation.x = kLinkSpacing * static_cast<double>(i);
    transform.transform.translation.y = kSwing * std::sin(angle);
    transform.transform.rotation.z = std::sin(0.1 * std::sin(angle));
    transform.transform.rotation.w = std::cos(0.1 * std::sin(angle));
  }
  return message;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot made for measuring tf: branches of equal depth on one base, every joint moving.
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

namespace link_bounds::bench {

struct TfRobot {
  std::string base;
  std::vector<std::string> frames;   ///< branch after branch, each from its root to its tip
  std::vector<std::string> parents;  ///< of the frames
  std::vector<std::string> links;    ///< those frames that are bounded
};

/// All frames are bounded, unless `links` is less than `depth`: then only the last ones of the one
/// branch are.
TfRobot tfRobot(std::size_t links, std::size_t depth);

/// The transforms of all joints, in the order of the frames, one message per millisecond: joints
/// swing, with up to 1 rad/s. The motion begins again after the last message without a jump.
std::vector<tf2_msgs::TFMessage> swing(const TfRobot& robot, std::size_t messages);

}  // namespace link_bounds::bench

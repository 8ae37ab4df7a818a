// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes that the links of a robot never leave, as tight as time allows.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "robot/reach/attained_pose.h"

namespace link_bounds {

/// A face of a box that is never left, and a pose that comes near it.
struct ReachFace {
  double at = 0;                       ///< proven: no point is beyond [m]
  double attained = 0;                 ///< where the face of the box in `pose` is [m]
  std::map<std::string, double> pose;  ///< values of joints [rad or m]; the others are at 0

  /// No pose is beyond `at`, and one is at most this far from it [m].
  double gap() const { return std::abs(at - attained); }
};

struct Reach {
  std::array<ReachFace, kFaces> faces;

  Aabb box() const;
  double maxGap() const;
};

struct ReachGoal {
  double accuracy;                   ///< of the gaps [m]
  Stop stop = [] { return false; };  ///< ends it with what is proven by then
  /// Called by one thread at a time: how many links of how many are as accurate as that, and the
  /// largest gap of any. May be null.
  std::function<void(std::size_t, std::size_t, double)> progress = {};
};

/// Of each link of `bounded`, no less than the distance of any of its points from the root's origin
/// in any pose [m].
std::vector<double> linkRadii(const Robot& robot, const BoundedRobot& bounded,
                              const std::vector<JointRange>& ranges);

/// One per link of `bounded`; nothing for a link without a box, and for one behind a joint whose
/// range is not known. Padding does not count.
std::vector<std::optional<Reach>> reachOf(const Robot& robot, const BoundedRobot& bounded,
                                          const std::vector<JointRange>& ranges,
                                          const ReachGoal& goal);

/// The box around all of them, which the robot never leaves; nothing if there are none.
std::optional<Reach> unionOf(const std::vector<std::optional<Reach>>& reaches);

}  // namespace link_bounds

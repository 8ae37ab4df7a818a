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

  /// The proven face minus the farthest pose that was found [m]: the face could move in by no more.
  double gap() const { return std::abs(at - attained); }
};

struct Reach {
  std::array<ReachFace, kFaces> faces;

  Aabb box() const;
  double maxGap() const;
};

struct ReachGoal {
  double accuracy;                   ///< of the gaps [m]
  Stop stop = [] { return false; };  ///< true: ends the search with the bounds proven by then
  /// Called by one thread at a time, with the number of links that have reached `accuracy`, the
  /// number of all links, and the largest gap [m]. May be null.
  std::function<void(std::size_t, std::size_t, double)> progress = {};
};

/// By link of `bounded`: upper bound of the distance of its points from the root's origin in any
/// pose [m]; infinite behind a joint whose range is not known.
std::vector<double> linkRadii(const Robot& robot, const BoundedRobot& bounded,
                              const std::vector<JointRange>& ranges);

/// One per link of `bounded`; nothing for a link without a box, and for one behind a joint whose
/// range is not known. Padding does not count.
std::vector<std::optional<Reach>> reachOf(const Robot& robot, const BoundedRobot& bounded,
                                          const std::vector<JointRange>& ranges,
                                          const ReachGoal& goal);

/// Why nothing is proven of that link of `bounded`, or only of a part of it.
std::string whyNoReach(const Robot& robot, const BoundedRobot& bounded,
                       const std::vector<JointRange>& ranges, std::size_t link);

/// The box around all reaches, which the robot never leaves; nothing if there are none.
std::optional<Reach> unionOf(const std::vector<std::optional<Reach>>& reaches);

}  // namespace link_bounds

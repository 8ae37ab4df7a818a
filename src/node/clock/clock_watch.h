// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// ROS time under observation: does it run, did it jump back?
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

namespace link_bounds {

class ClockWatch {
 public:
  enum class Event { kNone, kStarted, kJumpedBack };

  ClockWatch();

  /// Compares `now` with the last observation. Less than 0.1 s back is no jump.
  Event observe(ros::Time now);

  /// True for half a second of wall time after a jump and only for stamps more than 0.5 s ahead of
  /// ROS time: such transforms were sent before the jump and still on their way.
  bool isFromBeforeJump(ros::Time stamp, ros::Time now) const;

  /// True for five seconds of wall time after a jump.
  bool hasJustJumped() const;

  /// True if simulated time has not begun five seconds after this node.
  bool isMissing() const;

 private:
  ros::Time last_;
  ros::SteadyTime start_;
  ros::SteadyTime jump_;  ///< zero if there was none
};

}  // namespace link_bounds

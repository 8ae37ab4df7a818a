// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where ROS time was a moment of steady time ago. When the clock jumps ahead, what came just before
// is old by ROS time, although nobody was silent.
#pragma once

#include <ros/time.h>

namespace link_bounds {

class RecentTime {
 public:
  void observe(ros::Time now, ros::SteadyTime steady_now);

  /// At most that of the oldest observation in the last `moment` of steady time, up to the last
  /// observation; never that of one that is older than twice the moment.
  ros::Time since() const { return old_.time; }

  /// Begins over.
  void setMoment(ros::WallDuration moment);

 private:
  struct Observation {
    ros::Time time;
    ros::SteadyTime steady;
  };

  ros::WallDuration moment_;
  Observation old_, young_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// ROS time as objects see it, which may jump back.
#pragma once

#include <ros/time.h>

#include <cstdint>

#include "world/bodies/live_object.h"

namespace link_bounds {

/// Times are nanoseconds of ROS time: differences of ros::Time throw if they exceed a
/// ros::Duration.
class ObjectClock {
 public:
  /// The time, which is remembered.
  std::int64_t observe(ros::Time now);

  /// The time after the clock jumped back or began to run. What is left of an object's lifetime
  /// stays as it was.
  std::int64_t restart(ros::Time now);

  /// Where the object's age began, as restart() shifts it. To be called before restart().
  std::int64_t receivedAfterJump(const LiveObject& object, ros::Time now) const;

  /// Whether the content can have been stamped since the clock last jumped back or began
  /// to run.
  bool isSinceJump(const ObjectContent& content, std::int64_t now) const;

  /// The stamp of a box of this content. What was sent before the clock jumped back may arrive
  /// after it; it is stamped `now`.
  std::int64_t stampOf(const ObjectContent& content, std::int64_t now) const;

 private:
  std::int64_t start_ = 0;       ///< when the clock jumped back or began to run
  std::int64_t last_now_ = 0;    ///< the newest time since the clock jumped back
  std::int64_t newest_now_ = 0;  ///< the newest time before any jump back
};

/// True at the end of the object's lifetime.
bool hasExpired(const LiveObject& object, std::int64_t now);

}  // namespace link_bounds

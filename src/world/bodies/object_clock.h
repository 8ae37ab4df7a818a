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
  /// Notes the current time and returns it.
  std::int64_t observe(ros::Time now);

  /// Starts over after the clock jumped back or began to run, and returns `now`. The remaining
  /// lifetimes of objects stay the same if receivedAfterJump() was called for each before.
  std::int64_t restart(ros::Time now);

  /// The receipt time that gives the object the same age at `now` as before a jump. To be called
  /// before restart().
  std::int64_t receivedAfterJump(const LiveObject& object, ros::Time now) const;

  /// Whether the content's stamp is between the last jump back (or the start of the clock) and 0.5
  /// s after `now`.
  bool isSinceJump(const ObjectContent& content, std::int64_t now) const;

  /// The stamp for a box of this content. An object that was sent before the clock jumped back may
  /// arrive after it; its stamp is then `now`.
  std::int64_t stampOf(const ObjectContent& content, std::int64_t now) const;

 private:
  std::int64_t start_ = 0;       ///< when the clock jumped back or began to run
  std::int64_t last_now_ = 0;    ///< the newest time since the clock jumped back
  std::int64_t newest_now_ = 0;  ///< the newest time before any jump back
};

/// True if the object's lifetime is over.
bool hasExpired(const LiveObject& object, std::int64_t now);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// ROS times as signed numbers. Their differences do not overflow, unlike those of ros::Time.
#pragma once

#include <ros/time.h>

#include <cstdint>

namespace link_bounds {

inline std::int64_t nanosecondsOf(ros::Time time) {
  return static_cast<std::int64_t>(time.toNSec());
}

/// `nanoseconds` must not be negative.
inline ros::Time timeFrom(std::int64_t nanoseconds) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(nanoseconds));
}

}  // namespace link_bounds

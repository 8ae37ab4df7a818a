// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// When something was found, in record time.
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cstdint>

namespace link_bounds {

/// Nanoseconds.
struct RecordTime {
  std::int64_t recorded = 0;  ///< record time of the message that led to it
  std::int64_t stamp = 0;     ///< of the box or distance; 0 if all its transforms are static
};

/// The largest time of ros::Time is 4.29e18 ns.
constexpr std::int64_t kMaxTime = 4'200'000'000'000'000'000;

/// Times out of range become the nearest one that ros::Time can hold.
inline ros::Time toRosTime(std::int64_t nanoseconds) {
  return ros::Time().fromNSec(
      static_cast<std::uint64_t>(std::clamp<std::int64_t>(nanoseconds, 0, kMaxTime)));
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// When something was found, in record time, and times as text.
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace link_bounds {

/// Nanoseconds.
struct RecordTime {
  std::int64_t recorded = 0;  ///< record time of the message that led to it
  std::int64_t stamp = 0;     ///< of the box or distance; 0 if all its transforms are static
};

/// The largest time of ros::Time is 4.29e18 ns.
constexpr std::int64_t kMaxTime = 4'200'000'000'000'000'000;

/// How a body moved longer ago than this, tf may have forgotten [ns]: ten seconds, less what ticks
/// miss of the first transform.
constexpr std::int64_t kRemembered = 9'500'000'000;

/// A simulation begins at the stamp 0, which stands for static transforms elsewhere.
const ros::Time kStampOfZero(0, 1);

/// Times out of range become the nearest one that ros::Time can hold.
inline ros::Time toRosTime(std::int64_t nanoseconds) {
  return ros::Time().fromNSec(
      static_cast<std::uint64_t>(std::clamp<std::int64_t>(nanoseconds, 0, kMaxTime)));
}

/// Nanoseconds as seconds, from integers, so that none is lost.
std::string exactSeconds(std::int64_t nanoseconds);

/// A stamp [ns] in seconds, from integers, too, as it was recorded: kStampOfZero is 0.
std::string stampSeconds(std::int64_t stamp);

/// Seconds from `begin` to `time` [ns] for people.
std::string shortSeconds(std::int64_t time, std::int64_t begin);

}  // namespace link_bounds

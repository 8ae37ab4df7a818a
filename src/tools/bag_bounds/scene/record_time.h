// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Record times of findings, and times as text.
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace link_bounds {

/// All in nanoseconds.
struct RecordTime {
  std::int64_t recorded = 0;  ///< record time of the message that led to it
  std::int64_t stamp = 0;     ///< of the box or distance; 0 if all its transforms are static
};

/// Max time that is used [ns]; ros::Time ends at 4.29e18 ns.
constexpr std::int64_t kMaxTime = 4'200'000'000'000'000'000;

/// tf may have forgotten motions that are longer ago than this [ns]. It keeps ten seconds, but
/// ticks may notice the first transform late.
constexpr std::int64_t kRemembered = 9'500'000'000;

/// Stands for the stamp 0, at which a simulation begins: elsewhere 0 stands for static transforms.
const ros::Time kStampOfZero(0, 1);

/// Times out of range become the nearest one that ros::Time can hold.
inline ros::Time toRosTime(std::int64_t nanoseconds) {
  return ros::Time().fromNSec(
      static_cast<std::uint64_t>(std::clamp<std::int64_t>(nanoseconds, 0, kMaxTime)));
}

/// Nanoseconds as text in seconds, made from integers, so that no digit is lost.
std::string exactSeconds(std::int64_t nanoseconds);

/// A stamp [ns] as text in seconds, made from integers, too. kStampOfZero becomes 0 again.
std::string stampSeconds(std::int64_t stamp);

/// Seconds from `begin` to `time` [ns] for people.
std::string shortSeconds(std::int64_t time, std::int64_t begin);

}  // namespace link_bounds

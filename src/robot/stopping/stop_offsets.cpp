// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Upward; downward is the same with all signs changed.
#include "robot/stopping/stop_offsets.h"

#include <algorithm>

namespace link_bounds {
namespace {

/// More than the rounding of the formulas, of their result.
constexpr double kRounding = 1e-14;

/// Where it speeds up, a speed below 0 counts as 0: how fast it brakes from there has no limit.
double farthest(double speed, const Braking& braking, const Reaction& reaction) {
  double end = speed;
  double travelled = speed * reaction.time;
  if (reaction.may_speed_up) {
    const double start = std::max(speed, 0.0);
    const double top = std::max(start, braking.max_speed.value_or(start));
    const double rise = top - start;
    const bool is_at_once = !braking.acceleration;
    const double ramp = is_at_once ? 0 : std::min(reaction.time, rise / *braking.acceleration);
    const double gain = is_at_once ? rise : std::min(rise, *braking.acceleration * ramp);
    end = start + gain;
    travelled = (start + end) / 2 * ramp + end * (reaction.time - ramp);
  }
  const double braked = end > 0 ? end * end / (2 * braking.deceleration) : 0;
  return std::max(0.0, travelled + braked) * (1 + kRounding);
}

}  // namespace

Limits stopOffsets(const SpeedRange& speed, const Braking& braking, const Reaction& reaction) {
  return {-farthest(-speed.lower, braking, reaction), farthest(speed.upper, braking, reaction)};
}

}  // namespace link_bounds

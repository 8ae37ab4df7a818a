// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes motion upward; motion downward is the same with all signs changed.
#include "robot/stopping/stop_offsets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

/// Path and speed, both upward, when the braking begins.
struct Drive {
  double path;
  double speed;
};

Drive keepingSpeed(double speed, double time) {
  return {speed * time, speed};
}

/// A speed below 0 counts as 0: its braking to 0 has no limit.
Drive speedingUp(double speed, const Braking& braking, double time) {
  const double start = std::max(speed, 0.0);
  const double top = std::max(start, braking.max_speed.value_or(start));
  const double rise = top - start;
  const bool is_at_once = !braking.acceleration;
  const double ramp = is_at_once ? 0 : std::min(time, rise / *braking.acceleration);
  const double gain = is_at_once ? rise : std::min(rise, *braking.acceleration * ramp);
  const double end = start + gain;
  return {(start / 2 + end / 2) * ramp + end * (time - ramp), end};
}

/// The path, rounded up and at least 0; infinite if the numbers are too large.
double rounded(double path) {
  if (std::isnan(path)) return std::numeric_limits<double>::infinity();
  return std::max(0.0, path) * (1 + kFormulaRounding);
}

double farthest(double speed, const Braking& braking, const Reaction& reaction) {
  const auto [path, end] = reaction.may_speed_up ? speedingUp(speed, braking, reaction.time)
                                                 : keepingSpeed(speed, reaction.time);
  const double braked = end > 0 ? end * end / (2 * braking.deceleration) : 0;
  return rounded(path + braked);
}

double farthestTravel(double speed, const Braking& braking, double time) {
  return rounded(speedingUp(speed, braking, time).path);
}

}  // namespace

Limits stopOffsets(const SpeedRange& speed, const Braking& braking, const Reaction& reaction) {
  return {-farthest(-speed.lower, braking, reaction), farthest(speed.upper, braking, reaction)};
}

Limits travelOffsets(const SpeedRange& speed, const Braking& braking, double time) {
  return {-farthestTravel(-speed.lower, braking, time), farthestTravel(speed.upper, braking, time)};
}

}  // namespace link_bounds

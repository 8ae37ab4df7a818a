// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a joint can move until it stands.
//
// From time 0 to t_r, the reaction time, the joint keeps its speed v. Or it may speed up by at most
// a, but not beyond its limit V. From then on |v| falls by at least d per second until the joint
// stands. So it comes no farther than
//
//   x = v t_r + v^2 / (2 d)                        while it keeps its speed, v > 0;
//   x = V t_r + V^2 / (2 d)                        while it may reach V at once;
//   x = v t + a t^2 / 2 + e (t_r - t) + e^2 / (2 d)  where it reaches e = min(V, v + a t_r) at t.
#pragma once

#include <optional>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Speeds that a joint may have [rad/s or m/s]; lower <= upper.
struct SpeedRange {
  double lower = 0;
  double upper = 0;
};

/// What is known of how a joint brakes [rad/s^2 or m/s^2].
struct Braking {
  double deceleration;                      ///< > 0: its min when braking
  std::optional<double> acceleration = {};  ///< > 0: its max; none: any speed at once
  std::optional<double> max_speed = {};     ///< needed if the joint may speed up
};

/// What a joint does until it brakes.
struct Reaction {
  double time;        ///< [s]
  bool may_speed_up;  ///< to max_speed; a faster joint keeps its speed
};

/// How far the joint may be from where it is until it stands [rad or m]: lower <= 0 <= upper.
/// Infinite where a number is too large, and never NaN.
Limits stopOffsets(const SpeedRange& speed, const Braking& braking, const Reaction& reaction);

/// How far the joint may be from where it is at any moment until `time` has passed [s], if it may
/// speed up and never brakes, as in the reaction time of stopOffsets(). Needs Braking::max_speed.
Limits travelOffsets(const SpeedRange& speed, const Braking& braking, double time);

}  // namespace link_bounds

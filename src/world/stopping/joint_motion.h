// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a joint can come until it stands, from tf alone.
#pragma once

#include <optional>
#include <string>

#include "world/stopping/edge_samples.h"
#include "world/stopping/stop_rules.h"

namespace link_bounds {

/// The state of a joint at a stamp, from the transforms of a window before it.
struct JointState {
  double value = 0;     ///< [rad, from -pi to pi, or m]
  SpeedRange speed;     ///< all mean speeds of pieces of the window, see piecesOf()
  double piece = 0;     ///< the longest of these pieces [s]
  std::string problem;  ///< why it is not known, with the remedy
};

/// Of a joint that has a value and an axis. One that turns by 90 degrees or more between
/// two transforms is a problem: it may have turned the other way. So is a pose that does not fit
/// the joint to 1 mm and 1 mrad.
JointState jointState(const Joint& joint, const EdgeSamples& samples, std::int64_t stamp,
                      std::int64_t window);

/// With `acceleration`, the speeds at the end of any piece that a joint may have that speeds up no
/// faster: of mean v over a time h, it ends with at most max(v + a h / 2, a h). A faster one would
/// have moved all the time, and farther.
SpeedRange speedAtStamp(const JointState& state, std::optional<double> acceleration);

/// How far the joint may be from where it is until it stands, within its limits. Limits that the
/// value does not obey, or obeys in several ways, do not count.
Limits stopOffsetsWithin(const JointRule& rule, const JointState& state, const SpeedRange& speed,
                         const Reaction& reaction);

}  // namespace link_bounds

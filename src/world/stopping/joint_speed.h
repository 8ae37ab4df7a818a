// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a joint is and how fast it moves, and from there where it can come.
#pragma once

#include <optional>
#include <string>

#include "robot/stopping/joint_fit.h"
#include "world/stopping/edge_samples.h"
#include "world/stopping/joint_states.h"
#include "world/stopping/stop_rules.h"

namespace link_bounds {

/// The state of a joint at a stamp.
struct JointState {
  double value = 0;              ///< [rad or m]
  bool are_turns_known = false;  ///< of a joint that turns: else the value is from -pi to pi
  SpeedRange speed;              ///< all mean speeds of pieces of a window, see piecesOf()
  /// The longest of these pieces, and twice the time from the last report to the stamp [s].
  double piece = 0;
  /// By how much its way may differ from what the speeds tell [rad or m]: velocities may be late,
  /// or zeros of a driver that measures none. It may have sped up along that way.
  double unseen = 0;
  std::string problem;  ///< why it is not known, with the remedy
};

/// From transforms alone, and the pose at the stamp, of a joint that has a value and an axis. One
/// that turns by 90 degrees or more between two transforms is a problem: it may have turned the
/// other way. So is a pose that does not fit the joint to 1 mm and 1 mrad.
JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose, const EdgeSamples& samples,
                      std::int64_t window);

/// From reports of the joint, see JointStates, and its pose at the stamp, which must fit them. The
/// speeds are those that were reported and those of the positions; a single report is looked at
/// together with the last one `before` the window, if there is one. Where a report has no velocity,
/// or all are 0, as some drivers send it for what they do not measure, the positions alone tell:
/// then no two may be farther apart than the window; or, with all 0, the report `before` the window
/// had the same position, so the joint rested.
JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose,
                      const std::vector<JointReport>& reports, std::int64_t stamp,
                      std::int64_t window, const std::optional<JointReport>& before = {});

/// To be called before jointState(), with the joint that the reports are of. Joins the
/// positions of a continuous joint where its driver begins a turn anew; those with velocities stay
/// as they are. Returns why the direction is not known, if the joint turns by 90 degrees or more
/// between two reports; else "".
std::string unwrap(const Joint& joint, std::vector<JointReport>& reports);

/// Why the pose of a joint's child does not fit the joint; "" if it does.
std::string whyMisfit(const Joint& joint, const JointFit& fit);

/// With `acceleration`, the speeds at the end of any piece that a joint may have that speeds up no
/// faster: of mean v over a time h, it ends with at most max(v + a h / 2, a h). A faster one would
/// have moved all the time, and farther. In a time g after it, it gains a g more.
SpeedRange speedAtStamp(const JointState& state, std::optional<double> acceleration);

/// The offsets that lead to no value beyond the joint's limits. Limits that the value does not
/// obey, or obeys in several ways, do not count.
Limits withinLimits(Limits offsets, const JointRule& rule, const JointState& state);

}  // namespace link_bounds

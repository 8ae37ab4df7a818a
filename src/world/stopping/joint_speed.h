// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The value and the speed of a joint, and the offsets that its limits allow.
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
  bool are_turns_known = false;  ///< false: the value of a turning joint is from -pi to pi
  SpeedRange speed;              ///< of mean speeds of pieces, see piecesOf(), and velocities
  /// Length of the longest of these pieces, plus twice the time between a report and the stamp [s].
  /// Without the pieces if reported velocities agree with the positions.
  double piece = 0;
  /// Max motion that the speeds do not show [rad or m]: velocities may be late, or zeros of a
  /// driver that measures none. The joint may have accelerated along this motion.
  double unseen = 0;
  std::string problem;  ///< why the state is not known, with the remedy
};

/// From transforms alone. `pose` is the pose at the stamp; the joint must have a value and an axis.
/// A turn by 90 degrees or more between two transforms is a problem: the joint may have turned the
/// other way. So is a pose that does not fit the joint to 1 mm and 1 mrad.
JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose, const EdgeSamples& samples,
                      std::int64_t window);

/// From reports of the joint, see JointStates. `pose` is the pose at the stamp and must fit them.
/// Speeds come from the reported velocities and from the positions. A single report is combined
/// with the last one `before` the window, if there is one. Velocities do not count if one is
/// missing, or if all are 0, as drivers may send them without measuring. Then successive reports
/// must not be farther apart than the window, so that the positions give a speed. Or, if all
/// velocities are 0, the report `before` the window must have the same position: the joint rested.
JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose,
                      const std::vector<JointReport>& reports, std::int64_t stamp,
                      std::int64_t window, const std::optional<JointReport>& before = {});

/// To be called before jointState(), with the joint that the reports name. Adds full turns where
/// the driver of a continuous joint wraps its positions. Changes nothing if all reports have
/// velocities. Returns why the direction is not known, if the joint turns by 90 degrees or more
/// between two reports; else "".
std::string unwrap(const Joint& joint, std::vector<JointReport>& reports);

/// Why the pose of a joint's child does not fit the joint; "" if it does.
std::string whyMisfit(const Joint& joint, const JointFit& fit);

/// The speeds that the joint may have at the stamp. With a = `acceleration`, a piece of length h
/// and mean speed v ends with at most max(v + a h / 2, a h). For a joint that ends faster than a h
/// never stood in the piece, so its mean speed is at least its last speed minus a h / 2. In a time
/// g after the piece, it gains at most a g. Without `acceleration`, the measured speeds.
SpeedRange speedAtStamp(const JointState& state, std::optional<double> acceleration);

/// Restricts the offsets to the joint's limits. Changes nothing if the value is outside the limits,
/// or if full turns are not known and more than one turn fits the limits.
Limits withinLimits(Limits offsets, const JointRule& rule, const JointState& state);

}  // namespace link_bounds

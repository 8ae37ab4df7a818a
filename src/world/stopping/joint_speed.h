// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The value of a joint, the range of its speed, and the values that it can reach from there.
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
  bool are_turns_known = false;  ///< false: the value of a joint that turns is from -pi to pi
  SpeedRange speed;              ///< of the mean speeds of all pieces of a window, see piecesOf()
  /// The longest of these pieces plus twice the time from the last report to the stamp [s].
  double piece = 0;
  /// Max difference between the real motion of the joint and the motion by its velocities [rad or
  /// m]: these may be late, or zeros of a driver that does not measure them. The joint may have
  /// accelerated along this difference.
  double unseen = 0;
  std::string problem;  ///< why the state is not known, with the remedy
};

/// The state from transforms alone: `pose` is that at the stamp. The joint must have a value and an
/// axis. It is a problem if the joint turns by 90 degrees or more between two transforms, because
/// the direction is then unknown, or if a pose does not fit the joint within 1 mm and 1 mrad.
JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose, const EdgeSamples& samples,
                      std::int64_t window);

/// The state from reports of the joint, see JointStates, and its pose at the stamp, which must fit
/// them. Speeds come from the reported velocities and from the positions. A single report is used
/// together with the last one `before` the window, if there is one. If a report has no velocity, or
/// all are 0, as some drivers send when they measure none, the positions alone must give the speed:
/// no two of them may be farther apart than the window. All 0 also suffices if the report `before`
/// the window has the same position, because the joint then was at rest.
JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose,
                      const std::vector<JointReport>& reports, std::int64_t stamp,
                      std::int64_t window, const std::optional<JointReport>& before = {});

/// To be called before jointState(), with the joint of the reports. Makes the positions of a
/// continuous joint continuous where its driver wraps them; reports with velocities stay as they
/// are. Returns why the direction is not known, if the joint turns by 90 degrees or more between
/// two reports; else "".
std::string unwrap(const Joint& joint, std::vector<JointReport>& reports);

/// Why the pose of a joint's child does not fit the joint; "" if it does.
std::string whyMisfit(const Joint& joint, const JointFit& fit);

/// The range of the speed at the stamp. Without `acceleration` it is that of the state. With the
/// acceleration limit a, a joint of mean speed v during a piece of length h has at its end at most
/// the speed max(v + a h / 2, a h): a faster joint would have moved in the same direction during
/// the whole piece, and farther. In a time g after the piece it gains at most a g.
SpeedRange speedAtStamp(const JointState& state, std::optional<double> acceleration);

/// Cuts the offsets so that no value is beyond the joint's limits. Ignores the limits if the value
/// is outside, or if it is inside for several numbers of whole turns.
Limits withinLimits(Limits offsets, const JointRule& rule, const JointState& state);

}  // namespace link_bounds

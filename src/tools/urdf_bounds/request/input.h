// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The joint values that the command line names. Robots are those with simple joints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/pairs/srdf.h"
#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// One value per joint: the given ones [rad or m], which are ranges of lower == upper, 0 for the
/// others, and mimic joints follow. Warns about values that have no effect, and once about those
/// beyond limits, or refuses these. Throws UsageError, also for an unknown name, and JointError.
std::vector<double> valuesFor(const Robot& robot, const GivenRanges& given,
                              bool refuses_beyond_limits = false);

/// Where each joint can be. Warns about ranges that have no effect, once about those beyond limits,
/// and once about joints whose limits in the URDF are equal. With a fixed base, floating and planar
/// joints of the root stay at 0. Throws UsageError for an unknown name, and JointError.
std::vector<JointRange> rangesFor(const Robot& robot, GivenRanges given, bool has_fixed_base);

/// The text and the pairs of the file of --srdf; empty without one. Warns if it names another
/// robot.
struct Srdf {
  std::string text;
  std::vector<DisabledPair> pairs;
};
Srdf readSrdf(const std::optional<std::string>& file, const Robot& robot);

}  // namespace link_bounds

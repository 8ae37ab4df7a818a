// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joint values and ranges from the command line. Each `robot` has simple joints, see
// withSimpleJoints().
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/pairs/srdf.h"
#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// One value per joint [rad or m]. `given` holds ranges with lower == upper; other joints are at 0,
/// and mimic joints follow. Warns about values without effect, and once about values beyond limits,
/// or throws UsageError for the latter. Throws UsageError for an unknown name, and JointError.
std::vector<double> valuesFor(const Robot& robot, const GivenRanges& given,
                              bool refuses_beyond_limits = false);

/// The range of each joint [rad or m]. Warns about ranges that have no effect, once about those
/// beyond limits, and once about joints whose limits in the URDF are equal. With a fixed base,
/// floating and planar joints of the root stay at 0. Throws UsageError for an unknown name, and
/// JointError.
std::vector<JointRange> rangesFor(const Robot& robot, GivenRanges given, bool has_fixed_base);

/// The text and the pairs of the file of --srdf; empty without that option. Warns if the file names
/// another robot.
struct Srdf {
  std::string text;
  std::vector<DisabledPair> pairs;
};
Srdf readSrdf(const std::optional<std::string>& file, const Robot& robot);

}  // namespace link_bounds

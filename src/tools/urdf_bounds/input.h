// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The joint values that the command line names.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The pose of each link in the frame of the root link, for the given joint values [rad or m].
/// Warns about values that have no effect, and once about those beyond limits. Throws UsageError
/// for an unknown name, and JointError.
std::vector<Eigen::Isometry3d> posesFor(const Robot& robot,
                                        const std::map<std::string, double>& given);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the command line names: a URDF and joint values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The text of a file or of standard input ("-"). Throws UsageError with the reason.
std::string readText(const std::string& file);

/// Where relative mesh names of that file start.
std::string folderOf(const std::string& file);

/// The pose of each link in the frame of the root link, for the given joint values [rad or m].
/// Warns about values that have no effect, and once about those beyond limits. Throws UsageError
/// for an unknown name, and JointError.
std::vector<Eigen::Isometry3d> posesFor(const Robot& robot,
                                        const std::map<std::string, double>& given);

}  // namespace link_bounds

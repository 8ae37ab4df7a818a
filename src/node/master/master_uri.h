// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the ROS master is said to be.
#pragma once

namespace link_bounds {

/// Throws std::runtime_error if it cannot be read: roscpp would stop the process at a breakpoint.
/// It is that of the last argument __master, or of the environment. To be called before
/// ros::init().
void checkMasterUri(int argc, char** argv);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the programs have in common that `scripts/soak` runs beside a node.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

struct SoakArguments {
  int minutes;
  int pid;            ///< of the node
  double max_growth;  ///< of its memory after the first minute [bytes]
};

/// Instead of a verdict about memory after a single minute.
constexpr const char* kNoGrowth =
    "memory was not compared, because it counts from the end of the first minute";

/// Throws std::runtime_error if that takes longer than a minute.
void waitFor(const std::function<bool()>& condition, const char* what);

/// The robot of robot_description.
Robot describedRobot(const ros::NodeHandle& node);

/// For main(): reads the arguments, runs `soak` as a node of that name, with callbacks on a thread
/// of their own, and returns the exit status: 0 if `soak` returns true, 1 if not or if it throws, 2
/// if the arguments are wrong.
int runSoak(int argc, char** argv, const std::string& name,
            const std::function<bool(const SoakArguments&)>& soak);

}  // namespace link_bounds

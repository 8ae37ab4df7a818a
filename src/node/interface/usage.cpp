// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the tables of topics.h and parameter_table.h.
#include "node/interface/usage.h"

#include "node/interface/parameter_table.h"

namespace link_bounds {

std::string usage() {
  const Parameters defaults;
  return "usage: rosrun link_bounds link_bounds_publisher [_PARAMETER:=VALUE ...] [--help] "
         "[--version]\n\n"
         "_PARAMETER:=VALUE sets strings, numbers, true and false. Set lists and maps by rosparam\n"
         "or in a launch file.\n\n"
         "Publishes the exact axis-aligned bounding box of every link of the robot, in one fixed\n"
         "frame, at each tf update.\n\n" +
         interfaceTables(kTopics, kServices, [&](auto& rows) { visitParameters(defaults, rows); });
}

}  // namespace link_bounds

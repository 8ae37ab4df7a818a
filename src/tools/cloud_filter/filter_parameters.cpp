// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/filter_parameters.h"

#include "node/interface/usage.h"

namespace link_bounds {

std::string filterUsage() {
  const FilterParameters defaults;
  return "usage: rosrun link_bounds cloud_filter [_PARAMETER:=VALUE ...] [--help] [--version]\n\n"
         "Removes the points of the robot from point clouds and laser scans: by its exact meshes,\n"
         "at each point's own time.\n\n" +
         interfaceTables(kFilterTopics, kFilterServices,
                         [&](auto& rows) { visitFilterParameters(defaults, rows); });
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes that links never leave as text: a table to read, CSV, JSON or markers.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "robot/reach/reach.h"
#include "tools/formats/table_text.h"

namespace link_bounds {

/// All lengths in metres, in `frame`.
struct ReachTable {
  using NamedReach = std::pair<std::string, Reach>;

  std::string frame;
  double accuracy = 0;             ///< that was asked for
  std::vector<NamedReach> links;   ///< in the order of the URDF
  std::vector<NamedReach> groups;  ///< the robot, if any link has a box
  Reasons incomplete;
};

void write(const ReachTable& table, Format format, std::ostream& out);

/// A visualization_msgs/MarkerArray as YAML: the edges of each box.
void writeMarkers(const ReachTable& table, std::ostream& out);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes that another node publishes, as objects.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>

#include <map>
#include <set>
#include <string>

#include "world/bodies/live_object.h"

namespace link_bounds {

/// By name of the box at its sender. The contents have no name yet.
struct NeighbourBoxes {
  std::string frame;  ///< of the header, tf name
  std::map<std::string, ObjectContent> contents;
  std::map<std::string, std::string> refused;  ///< why
};

/// What a message of the node `sender` stands for: one object per name in `boxes` or `incomplete`.
/// Several boxes of one name become one around them. What the sender has from its own neighbours is
/// left out; else two nodes that hear each other would hand boxes back and forth for ever.
NeighbourBoxes neighbourBoxes(const AxisAlignedBoxArray& array, const std::string& sender);

/// The names in a message that are no objects, which tell robots apart.
std::set<std::string> linksOf(const NeighbourBoxes& boxes);

}  // namespace link_bounds

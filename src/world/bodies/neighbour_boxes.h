// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes that another node publishes, as objects.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>

#include <map>
#include <set>
#include <string>

#include "world/bodies/live_object.h"

namespace link_bounds {

/// The boxes of one message, by the name that the sender gives them. The contents have no name yet.
struct NeighbourBoxes {
  std::string frame;  ///< of the header, tf name
  std::map<std::string, ObjectContent> contents;
  std::map<std::string, std::string> refused;  ///< the reason, by name
};

/// Converts a message of the node `sender`: one object per name in `boxes` or `incomplete`. Several
/// boxes of one name become one box around them. Boxes that the sender got from its own neighbours
/// are skipped; otherwise two nodes that hear each other would pass boxes back and forth for ever.
NeighbourBoxes neighbourBoxes(const AxisAlignedBoxArray& array, const std::string& sender);

/// The names in a message that are not names of objects: links, which tell robots apart.
std::set<std::string> linksOf(const NeighbourBoxes& boxes);

}  // namespace link_bounds

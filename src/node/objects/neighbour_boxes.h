// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes that another node publishes, as objects.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>

#include <map>
#include <string>

#include "node/names/object_key.h"
#include "node/objects/live_object.h"

namespace link_bounds {

struct NeighbourBoxes {
  std::map<ObjectKey, ObjectContent> contents;
  std::map<std::string, std::string> refused;  ///< why, by name of the box at its sender
};

/// What a message of the node `sender` stands for: one object per name in `boxes` or `incomplete`.
/// Several boxes of one name become one around them. What the sender has from its own neighbours is
/// left out; else two nodes that hear each other would hand boxes back and forth for ever.
NeighbourBoxes neighbourBoxes(const AxisAlignedBoxArray& array, const std::string& sender);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes as messages.
#pragma once

#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/box_groups.h"
#include "live_boxes.h"

namespace link_bounds {

/// Overwrites `message` with the link boxes; reuses its memory.
void fillBoxes(const LiveBoxes& live, AxisAlignedBoxArray& message);

/// The same for the groups.
void fillGroups(const LiveBoxes& live, AxisAlignedBoxArray& message);

}  // namespace link_bounds

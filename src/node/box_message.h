// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes as messages.
#pragma once

#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "scene.h"

namespace link_bounds {

/// Overwrites `message` with the boxes of links and objects; reuses its memory. There must be a
/// model.
void fillBoxes(const Scene& scene, AxisAlignedBoxArray& message);

/// The same for the groups.
void fillGroups(const Scene& scene, AxisAlignedBoxArray& message);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of the past as a message.
#pragma once

#include "link_bounds/AxisAlignedBoxArray.h"
#include "world/history/past_boxes.h"

namespace link_bounds {

/// Overwrites `message`. The header has the stamp of the request, or that of the newest box if the
/// latest ones are asked for.
void fillBoxes(const PastScene& scene, const PastBoxes& boxes, const BoxRequest& request,
               AxisAlignedBoxArray& message);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Swept boxes as markers for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "link_bounds/AxisAlignedBoxArray.h"

namespace link_bounds {

/// Translucent faces of all boxes, and their edges, in the namespace "link_bounds/swept". What is
/// not there is deleted.
visualization_msgs::MarkerArray sweptMarkers(const AxisAlignedBoxArray& boxes);

/// As sweptMarkers(), of the boxes of ~stopping, in another colour.
visualization_msgs::MarkerArray stoppingMarkers(const AxisAlignedBoxArray& boxes);

}  // namespace link_bounds

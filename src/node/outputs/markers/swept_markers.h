// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Swept boxes as markers for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "link_bounds/AxisAlignedBoxArray.h"

namespace link_bounds {

/// Translucent faces and edges of all boxes, in the namespace "link_bounds/swept". Without boxes,
/// both markers are deleted.
visualization_msgs::MarkerArray sweptMarkers(const AxisAlignedBoxArray& boxes);

/// Like sweptMarkers(), for the boxes of ~stopping, in the namespace "link_bounds/stopping" and
/// another color.
visualization_msgs::MarkerArray stoppingMarkers(const AxisAlignedBoxArray& boxes);

}  // namespace link_bounds

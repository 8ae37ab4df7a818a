// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances as markers for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "link_bounds/DistanceArray.h"

namespace link_bounds {

/// One line per pair, between its two nearest points: red if the distance is `red` metres or less,
/// green at `limit` metres. The smallest distance has a thicker line and a text. Markers without
/// content are deleted.
visualization_msgs::MarkerArray distanceMarkers(const DistanceArray& distances,
                                                const Distance& nearest, double red, double limit);

}  // namespace link_bounds

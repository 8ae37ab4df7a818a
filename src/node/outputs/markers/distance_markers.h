// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances as markers for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "link_bounds/DistanceArray.h"

namespace link_bounds {

/// A line per pair between its two points, from red at `red` metres and below to green at `limit`.
/// The smallest distance has a thicker line and is there as text. What is not there is deleted.
visualization_msgs::MarkerArray distanceMarkers(const DistanceArray& distances,
                                                const Distance& nearest, double red, double limit);

}  // namespace link_bounds

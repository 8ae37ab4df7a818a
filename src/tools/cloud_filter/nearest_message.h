// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The message of ~nearest.
#pragma once

#include <link_bounds/DistanceArray.h>

#include <string>
#include <vector>

#include "world/cloud/nearest_points.h"

namespace link_bounds {

/// One distance per body that has a nearest point, from the body to `cloud`, in the order of
/// `names`.
DistanceArray nearestMessage(const std_msgs::Header& header, const std::vector<std::string>& names,
                             const std::vector<std::optional<NearestPoint>>& nearest,
                             const std::vector<std::string>& incomplete);

}  // namespace link_bounds

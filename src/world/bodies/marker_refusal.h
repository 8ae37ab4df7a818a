// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a marker can be bounded.
#pragma once

#include <visualization_msgs/Marker.h>

#include <string>

namespace link_bounds {

/// Why the marker cannot be bounded, with the remedy; "" if it can be, or if it is ignored. Not for
/// markers that delete.
std::string whyMarkerRefused(const visualization_msgs::Marker& marker);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which transforms can never be used, by the rules of tf2's setTransform.
#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <string_view>

namespace link_bounds {

/// Why the transform is refused, with the remedy; null if it is not.
const char* whyRefused(const geometry_msgs::TransformStamped& transform);

/// As tf2 understands names: without one leading slash.
std::string_view strippedFrame(std::string_view name);

}  // namespace link_bounds

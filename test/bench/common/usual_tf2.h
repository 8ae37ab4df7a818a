// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a node usually does with tf2: look up each link, turn its resting box and box that again,
// fill a new message, of markers or of boxes.
#pragma once

#include <tf2/buffer_core.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds::bench {

struct UsualLink {
  std::string frame;
  Aabb resting;
};

/// Links that tf2 does not know are left out.
visualization_msgs::MarkerArray usualMarkers(const tf2::BufferCore& buffer,
                                             const std::string& fixed_frame,
                                             const std::vector<UsualLink>& links);

/// The message of `~boxes`; links that tf2 does not know are in incomplete.
AxisAlignedBoxArray usualBoxes(const tf2::BufferCore& buffer, const std::string& fixed_frame,
                               const std::vector<UsualLink>& links);

}  // namespace link_bounds::bench

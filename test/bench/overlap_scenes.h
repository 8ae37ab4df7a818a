// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes in motion; the same in every run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds::bench {

using SceneBoxes = std::vector<Aabb>;

struct OverlapScene {
  std::string name;
  /// Overwrites the boxes by those of the next step; all have moved.
  std::function<void(SceneBoxes& boxes)> advance;
};

/// Each of about `count` boxes, in the order in which they are reported.
std::vector<OverlapScene> overlapScenes(std::size_t count);

}  // namespace link_bounds::bench

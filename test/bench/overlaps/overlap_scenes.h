// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of moving boxes, the same in every run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds::bench {

using SceneBoxes = std::vector<Aabb>;

struct OverlapScene {
  std::string name;
  /// Replaces the boxes by those of the next step. All have moved.
  std::function<void(SceneBoxes& boxes)> advance;
};

/// All scenes, each of about `count` boxes, in the order of the report.
std::vector<OverlapScene> overlapScenes(std::size_t count);

}  // namespace link_bounds::bench

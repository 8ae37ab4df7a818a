// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The convex hull of each link with padding, in its pose at the stamp of the cloud.
#pragma once

#include <geometric_shapes/bodies.h>

#include <memory>
#include <vector>

#include "bench/cloud/cloud_scenes.h"

namespace link_bounds::bench {

struct PosedHull {
  std::shared_ptr<bodies::ConvexMesh> body;
  bodies::BoundingSphere sphere;  ///< in the sensor's frame, as the body's pose
};

std::vector<PosedHull> posedHulls(const CloudScene& scene);

}  // namespace link_bounds::bench

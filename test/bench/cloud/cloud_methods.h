// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How others find the points of the robot.
#pragma once

#include <functional>

#include "bench/cloud/cloud_scenes.h"

namespace link_bounds::bench {

/// Labels all points of the cloud once, and returns how many are the robot's.
using LabelAll = std::function<std::size_t()>;

/// bodies::ConvexMesh with padding, for each link with its pose at the header's stamp; null if a
/// link has no hull. The scene must outlive it.
LabelAll geometricShapes(const CloudScene& scene);

/// pcl::CropHull of the same hulls, of the points in the same bounding spheres.
LabelAll cropHull(const CloudScene& scene);

}  // namespace link_bounds::bench

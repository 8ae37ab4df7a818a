// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Points in double, laid out for vector instructions, and the scan over all of them.
#pragma once

#include "link_bounds/point_set.h"

namespace link_bounds {

/// A copy, and the largest |x|, |y| and |z|. `points` must not be empty.
PointLanes packed(const DoublePoints& points, Eigen::Vector3d& magnitude);

/// As PointSet::extents.
Extents scannedExtents(const PointLanes& lanes, const Directions& directions);

}  // namespace link_bounds

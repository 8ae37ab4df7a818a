// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The scan over all points of a set in double; `xyz` and `count` as for PointSet. A list that does
// not fit into the cache is read to and fro, magnitude upwards and extents downwards, so that each
// pass begins where the one before it ended.
#pragma once

#include "link_bounds/geometry/support/query/extents.h"

namespace link_bounds {

/// The largest |x|, |y| and |z|.
Eigen::Vector3d scannedMagnitude(const double* xyz, std::size_t count);

/// As PointSet::extents, by the path in use.
Extents scannedExtents(const double* xyz, std::size_t count, const Directions& directions);

/// The same by the plain path.
Extents scanPlain(const double* xyz, std::size_t count, const Directions& directions);

}  // namespace link_bounds

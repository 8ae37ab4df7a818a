// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The point of a set that lies farthest along a direction.
#pragma once

#include "geometry/support/table/direction_table.h"

namespace link_bounds {

/// The first point of a cell's list with the largest d . p, evaluated as extents() does.
Eigen::Vector3d farthestPoint(const DirectionTable& table, const Eigen::Vector3d& direction);

/// The same for points in double, as in PointSet.
Eigen::Vector3d farthestPoint(const double* xyz, std::size_t count,
                              const Eigen::Vector3d& direction);

}  // namespace link_bounds

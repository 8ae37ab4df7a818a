// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The cheap way to see that a point cannot be extreme in a cone of directions.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace link_bounds {

/// A convex cone, by the directions of its edges in order around it.
using Cone = std::vector<Eigen::Vector3d>;

using PointIndices = std::vector<std::uint32_t>;

/// Drops candidates p whose sign * (p . d) another candidate exceeds by more than `margin` at every
/// corner: a linear function that is smaller at the corners is smaller in the whole cone between
/// them. Only a few other candidates are tried, those with the largest products.
void dropDominated(const std::vector<Eigen::Vector3d>& points, const Cone& corners, double sign,
                   double margin, PointIndices& candidates);

}  // namespace link_bounds

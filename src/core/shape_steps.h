// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The steps of a box, for who computes many.
#pragma once

#include "link_bounds/shape.h"

namespace link_bounds {

/// Looks for what the box depends on. The next box of this shape and reach must be of this very
/// pose; it is then quicker, the more so if much else is done in between.
void announce(const Shape& shape, const Eigen::Affine3d& world_from_shape, ShapeReach& reach);

/// As placedBox(); false if there is no box.
bool placeBox(const Shape& shape, const Eigen::Affine3d& world_from_shape, ShapeReach& reach,
              Aabb& box);

}  // namespace link_bounds

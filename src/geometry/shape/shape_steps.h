// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The steps of a box, for who computes many.
#pragma once

#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// Finds the cells that the box reads and begins to fetch them. Returns false, and leaves `cells`
/// as they are, for a shape that has none or a pose of which `reach` knows some of the rows.
bool prefetchCells(const Shape& shape, const Eigen::Affine3d& world_from_shape,
                   const ShapeReach& reach, CellsOfRows& cells);

/// As placedBox(); false if there is no box. `cells` are those of this shape and pose, or null.
bool placeBox(const Shape& shape, const Eigen::Affine3d& world_from_shape, const CellsOfRows* cells,
              ShapeReach& reach, Aabb& box);

}  // namespace link_bounds

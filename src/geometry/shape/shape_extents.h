// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far one shape extends along the axes of the world, and the steps from there to its box.
#pragma once

#include <limits>

#include "geometry/support/query/direction_query.h"
#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// Extents of one shape from its own origin, for the linear part of a pose. Kept from one update
/// to the next, they save all work but the translation for axes whose row has not changed.
struct ShapeExtents {
  explicit ShapeExtents(const Shape& shape);

  /// The linear part of world_from_shape; NaN where the extents are not known.
  Eigen::Matrix3d linear = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Extents extents;               ///< without translation [m]; rounded outward
  double pad_per_entry;          ///< against rounding, for an entry of 1 in the linear part [m]
  DirectionTable::Lookup table;  ///< of the shape's points; no cells if they have none
  bool is_in_link_frame;         ///< link_from_shape is the identity
};

/// Finds the cells that the box reads and prefetches them. Returns false, and leaves `cells` as
/// they are, for a shape without a table or a pose of which some rows are known.
bool prefetchCells(const Eigen::Affine3d& world_from_shape, const ShapeExtents& known,
                   CellsOfRows& cells);

/// The box of worldBox(); false if there is none. `known` must have been made for this shape, and
/// changes speed and nothing else. `lists` are those of this pose, or null.
bool placeShape(const Shape& shape, const Eigen::Affine3d& world_from_link,
                const ListsOfRows* lists, ShapeExtents& known, Aabb& box);

}  // namespace link_bounds

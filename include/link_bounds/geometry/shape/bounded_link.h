// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// One link with everything on it that has a shape. Lengths are metres. Nothing here throws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

struct BoundedLink {
  std::string name;           ///< as in the URDF
  std::vector<Shape> shapes;  ///< what could be loaded; may be empty
  double padding = 0;         ///< added on every side of the box [m], finite, >= 0
  std::string missing;        ///< why the shapes are not all of the link's geometry; "" = they are

  bool isWhole() const { return missing.empty(); }
};

/// An upper bound of the |coordinates| of the shapes' points in the link's frame [m], without
/// padding. Rounding errors of computations in that frame are proportional to it.
double magnitude(const BoundedLink& link);

/// The box around all shapes of the link in the world: tight, rounded outward and padded. Nothing
/// if the link has no shape, or if a shape has no box in this pose (see worldBox). For links that
/// move again and again, LinkBoxes is faster.
std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link);

}  // namespace link_bounds

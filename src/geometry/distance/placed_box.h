// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of two trees where a search sees them, and how far they are apart.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/distance/convex_sets.h"

namespace link_bounds {

/// A parallelepiped in the coordinates of a search.
struct PlacedBox {
  PlacedBox(const Parallelepiped& box, const Placement& at) : center(at.toSearch(box.center)) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges[k] = at.linear * box.edges[k];
      const double squared = edges[k].squaredNorm();
      inverse[k] = std::isnormal(squared) ? 1 / squared : 0;  // a flat pose leaves edges no length
    }
  }

  /// A point of the box: the nearest one if the edges are orthogonal, as in a rigid pose.
  Eigen::Vector3d near(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from = point - center;
    Eigen::Vector3d result = center;
    for (std::size_t k = 0; k < 3; ++k)
      result += std::min(std::max(edges[k].dot(from) * inverse[k], -1.0), 1.0) * edges[k];
    return result;
  }

  /// Half of the width along a unit direction.
  double extent(const Eigen::Vector3d& direction) const {
    return std::abs(edges[0].dot(direction)) + std::abs(edges[1].dot(direction)) +
           std::abs(edges[2].dot(direction));
  }

  Eigen::Vector3d center;
  std::array<Eigen::Vector3d, 3> edges;
  std::array<double, 3> inverse;  ///< of the squared lengths of the edges
};

/// What is known of the distance of two sets.
struct Separation {
  double lower;            ///< proven [m]
  double near;             ///< about the distance, and not below it unless it says infinity
  Eigen::Vector3d normal;  ///< unit; a direction in which the sets may be separate
  bool is_along = false;   ///< `lower` is proven along `normal`

  /// If that is more.
  void raise(double lower_along, const Eigen::Vector3d& along) {
    if (!(lower_along > lower)) return;
    lower = lower_along;
    normal = along;
    is_along = true;
  }
};

/// Raises `known.lower` until it is at least `far_enough`, or until the boxes are proven to be
/// nearer, or for a few steps. `rounding` is what a computed bound may be too large by. Projects a
/// point from box to box: faster than GJK, and it need not converge.
void separate(const PlacedBox& first, const PlacedBox& second, double far_enough, double rounding,
              Separation& known);

}  // namespace link_bounds

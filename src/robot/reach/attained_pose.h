// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A pose in which a link extends far along an axis.
#pragma once

#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "robot/reach/reach_bound.h"

namespace link_bounds {

/// The faces of a box: min x, y, z, then max x, y, z.
constexpr std::size_t kFaces = 6;

inline double faceOf(const Aabb& box, std::size_t face) {
  const auto axis = static_cast<Eigen::Index>(face % 3);
  return face < 3 ? box.min()[axis] : box.max()[axis];
}

/// By how much a face at `further` is outside one at `other` [m]; negative if it is inside.
inline double beyond(std::size_t face, double further, double other) {
  return face < 3 ? other - further : further - other;
}

struct AttainedFace {
  double at = 0;               ///< where that face of the link's box is in this pose [m]
  std::vector<double> values;  ///< one per variable of the chain, in its range
};

/// Where that face of the link's box is in the pose of `values` [m]. `link` has a box in every
/// pose.
double faceAt(const JointPath& chain, const BoundedLink& link, std::size_t face,
              const std::vector<double>& values);

/// Moves the face outward from the pose of `start`, one variable at a time, until no small step
/// moves it further, or until stopped.
AttainedFace attainedFrom(const JointPath& chain, const BoundedLink& link, std::size_t face,
                          std::vector<double> start, const Stop& stop);

}  // namespace link_bounds

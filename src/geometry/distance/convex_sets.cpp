// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The farthest points of the unit box, ball and cylinder, scaled.
#include "geometry/distance/convex_sets.h"

#include "link_bounds/geometry/box/length.h"

namespace link_bounds {

Eigen::Vector3d farthestOf(Solid solid, const Eigen::Vector3d& size,
                           const Eigen::Vector3d& direction) {
  const Eigen::Vector3d half = size / 2;
  const auto signedHalf = [&](int k) { return std::copysign(half[k], direction[k]); };
  switch (solid) {
    case Solid::kNone:
      break;
    case Solid::kBox:
      return {signedHalf(0), signedHalf(1), signedHalf(2)};
    case Solid::kEllipsoid: {
      const Eigen::Vector3d scaled = half.cwiseProduct(direction);
      const double norm = length(scaled.x(), scaled.y(), scaled.z());
      if (!(norm > 0)) return {half.x(), 0, 0};
      return half.cwiseProduct(scaled / norm);
    }
    case Solid::kCylinder: {
      const Eigen::Vector2d scaled = half.head<2>().cwiseProduct(direction.head<2>());
      const double norm = length(scaled.x(), scaled.y());
      if (!(norm > 0)) return {half.x(), 0, signedHalf(2)};
      return {half.x() * (scaled.x() / norm), half.y() * (scaled.y() / norm), signedHalf(2)};
    }
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace link_bounds

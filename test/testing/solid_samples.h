// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Points of the surface of solids, dense enough to stand for all of them.
#pragma once

#include <cmath>
#include <vector>

#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// A circle's samples miss its extreme by at most this part of its radius: 1 - cos(half a step).
inline double samplingLoss(int steps) {
  return 1 - std::cos(M_PI / steps);
}

/// Points of the surface of a unit solid (extent 1 along each axis) that include every extreme
/// one up to samplingLoss; `steps` around a circle.
inline std::vector<Eigen::Vector3d> surface(Solid solid, int steps) {
  std::vector<Eigen::Vector3d> result;
  if (solid == Solid::kNone) return {Eigen::Vector3d::Zero()};
  if (solid == Solid::kBox) {
    for (int i = 0; i < 8; ++i) {
      result.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    }
    return result;
  }
  for (int i = 0; i < steps; ++i) {
    const double around = 2 * M_PI * i / steps;
    const Eigen::Vector3d rim(0.5 * std::cos(around), 0.5 * std::sin(around), 0);
    if (solid == Solid::kCylinder) {
      result.push_back(rim + Eigen::Vector3d(0, 0, 0.5));
      result.push_back(rim - Eigen::Vector3d(0, 0, 0.5));
      continue;
    }
    for (int j = 0; j <= steps / 2; ++j) {
      const double down = 2 * M_PI * j / steps;
      result.push_back(rim * std::sin(down) + Eigen::Vector3d(0, 0, 0.5 * std::cos(down)));
    }
  }
  return result;
}

}  // namespace link_bounds

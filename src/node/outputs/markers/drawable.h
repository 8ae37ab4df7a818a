// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What rviz can draw.
#pragma once

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

constexpr double kMaxDrawable = 1e18;  ///< squares of larger numbers overflow rviz's float32 [m]

inline bool isDrawable(const Aabb& box) {
  return box.min().cwiseAbs().maxCoeff() <= kMaxDrawable &&
         box.max().cwiseAbs().maxCoeff() <= kMaxDrawable;
}

}  // namespace link_bounds

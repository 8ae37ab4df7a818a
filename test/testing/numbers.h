// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers and a pose that many tests need.
#pragma once

#include <Eigen/Geometry>
#include <limits>

namespace link_bounds {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline const Eigen::Affine3d kIdentity = Eigen::Affine3d::Identity();

}  // namespace link_bounds

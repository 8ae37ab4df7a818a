// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// How far points extend along three directions.
#pragma once

#include <Eigen/Core>

namespace link_bounds {

/// The smallest and largest r . p over the points p of a set, for three directions r; metres.
struct Extents {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

/// Three directions, as the rows of a matrix or of the linear part of a pose; copies nothing.
using Directions = Eigen::Ref<const Eigen::Matrix3d, 0, Eigen::OuterStride<>>;

}  // namespace link_bounds

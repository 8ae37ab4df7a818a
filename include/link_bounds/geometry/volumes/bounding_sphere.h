// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The bounding sphere of a link, the first volume of the paper's Figure 2.
///
/// It is computed once, in the frame of the link. When the link moves, only its centre moves. That
/// takes less time than a new box, but around a long link most of the sphere is empty.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "link_bounds/geometry/shape/link_boxes.h"

namespace link_bounds {

struct BoundingSphere {
  Eigen::Vector3d center;  ///< metres
  double radius;           ///< metres, >= 0
};

/// A sphere around all shapes of the link and its padding, in the frame of the link. Contains all
/// that it bounds. Without padding, its radius is larger than that of the smallest sphere by at
/// most 1e-6 of itself plus 1e-12 of the link's magnitude. Nothing if linkBox() gives nothing in
/// that frame.
std::optional<BoundingSphere> boundingSphere(const BoundedLink& link);

/// The sphere at the pose of its link, rounded outward. A pose that is not quite rigid makes it
/// larger. Nothing if it would not be finite.
std::optional<BoundingSphere> placed(const BoundingSphere& sphere,
                                     const Eigen::Isometry3d& world_from_link);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The bounding sphere of a link, the first volume of the paper's Figure 2.
///
/// It is computed once, in the frame of the link; at each update only its centre moves. It needs no
/// direction table then, but a long link leaves it mostly empty.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "link_bounds/geometry/shape/link_boxes.h"

namespace link_bounds {

struct BoundingSphere {
  Eigen::Vector3d center;  ///< metres
  double radius;           ///< metres, >= 0
};

/// A sphere around all shapes of the link and its padding, in the frame of the link. Never smaller
/// than what it bounds; without padding, its radius is at most 1e-6 of itself larger than that of
/// the smallest sphere, plus 1e-12 of the link's magnitude. Nothing if the link has no shape, or
/// none that linkBox could bound.
std::optional<BoundingSphere> boundingSphere(const BoundedLink& link);

/// The sphere of the link where the link is now. Rounded outward; a pose that is not quite rigid
/// makes it larger. Nothing if it would not be finite.
std::optional<BoundingSphere> placed(const BoundingSphere& sphere,
                                     const Eigen::Isometry3d& world_from_link);

}  // namespace link_bounds

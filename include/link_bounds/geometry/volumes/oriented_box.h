// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The oriented bounding box of a link, the third volume of the paper's Figure 2.
///
/// It is computed once, in the frame of the link, and turns with the link. It is tighter than a box
/// along the axes of the world, but two of them take longer to compare.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "link_bounds/geometry/shape/link_boxes.h"

namespace link_bounds {

struct OrientedBox {
  Eigen::Vector3d center;          ///< metres
  Eigen::Quaterniond orientation;  ///< rotates the axes of the frame onto those of the box
  Eigen::Vector3d size;            ///< full widths along the axes of the box [m], >= 0
};

/// A small box around all shapes of the link and its padding, in the frame of the link. Contains
/// all that it bounds. The search tries some 3000 orientations and refines the best one. So the box
/// is a good one, but not proven to be the smallest. Equal links always get equal boxes.
/// - For its orientation the box is too large by at most 1e-12 of the link's magnitude.
/// - It never has more volume than linkBox() in the frame of the link. It has the orientation of
///   that frame if another one would save less than 1e-6 of the volume.
/// - For volumes, a width counts as at least 1e-9 of the link's diagonal or 1e-12 of its magnitude,
///   so the area decides how to turn a flat link.
/// Nothing if linkBox() gives nothing in the frame of the link.
std::optional<OrientedBox> orientedBox(const BoundedLink& link);

/// The box at the pose of its link, rounded outward. A pose that is not quite rigid makes it
/// larger. Nothing if it would not be finite.
std::optional<OrientedBox> placed(const OrientedBox& box, const Eigen::Isometry3d& world_from_link);

}  // namespace link_bounds

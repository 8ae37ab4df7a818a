// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The oriented bounding box of a link, the third volume of the paper's Figure 2.
///
/// It is computed once, in the frame of the link, and turns with it. It fits more closely than a
/// box along the axes of the world, but two of them are harder to compare.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "link_bounds/geometry/shape/link_boxes.h"

namespace link_bounds {

struct OrientedBox {
  Eigen::Vector3d center;          ///< metres
  Eigen::Quaterniond orientation;  ///< turns the axes of the frame into those of the box
  Eigen::Vector3d size;            ///< full widths along the axes of the box [m], >= 0
};

/// A small box around all shapes of the link and its padding, in the frame of the link. Some 3000
/// orientations are tried and the best one is refined, so it is good but not proven to be the
/// smallest. Never smaller than what it bounds, by no more than 1e-12 of the link's magnitude
/// larger than it must be for its orientation, and never of more volume than linkBox in the link's
/// own frame; of that orientation where turning gains less than 1e-6 of the volume. For volumes, a
/// width counts as at least 1e-9 of the link's diagonal or 1e-12 of its magnitude, so that of a
/// flat link the area decides. Always the same for the same link. Nothing if linkBox gives nothing
/// there.
std::optional<OrientedBox> orientedBox(const BoundedLink& link);

/// The box of the link where the link is now. Rounded outward; a pose that is not quite rigid makes
/// it larger. Nothing if it would not be finite.
std::optional<OrientedBox> placed(const OrientedBox& box, const Eigen::Isometry3d& world_from_link);

}  // namespace link_bounds

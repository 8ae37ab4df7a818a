// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks the boxes of a link whose mesh file may be damaged.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "testing/brute_force.h"

namespace link_bounds {

/// Turned about one axis by 30 or 45 degrees, obliquely, sheared and mirrored, far away.
std::vector<Eigen::Affine3d> obliquePoses(brute_force::Random& random);

/// Checks the boxes of a link whose only shape has these points: each box is finite, contains the
/// exact one and exceeds it by no more than shape.h permits; before rounding, its extents are those
/// of a loop over the points, except for ties. Returns the first fault, "" if there is none.
std::string faultOfLoaded(const BoundedLink& link, const std::vector<Eigen::Vector3f>& points,
                          const std::vector<Eigen::Affine3d>& poses);

/// Checks a link whose mesh was refused: it has no shape and no box, but a reason.
std::string faultOfRefused(const BoundedLink& link);

}  // namespace link_bounds

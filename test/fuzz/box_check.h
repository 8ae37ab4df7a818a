// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the boxes of a link are what they have to be, whatever its mesh file was.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/geometry/shape/link_boxes.h"
#include "testing/brute_force.h"

namespace link_bounds {

/// Turned about one axis by 30 or 45 degrees, obliquely, sheared and mirrored, far away.
std::vector<Eigen::Affine3d> obliquePoses(brute_force::Random& random);

/// What is wrong with the boxes of a link that has these points as its only shape; "" if nothing:
/// each is finite, contains the exact one and is larger by no more than shape.h admits, and the
/// extents before rounding are those of a loop over the points, but for ties.
std::string faultOfLoaded(const BoundedLink& link, const std::vector<Eigen::Vector3f>& points,
                          const std::vector<Eigen::Affine3d>& poses);

/// The same of a link whose mesh was refused: it has no shape and no box, and says why.
std::string faultOfRefused(const BoundedLink& link);

}  // namespace link_bounds

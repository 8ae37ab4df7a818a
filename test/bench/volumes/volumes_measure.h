// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Measures how large volumes are and what they cost.
#pragma once

#include "bench/common/result.h"
#include "bench/common/robots.h"

namespace link_bounds::bench {

// Names of rows, by what was measured.
constexpr char kAabb[] = "aabb";  ///< along fixed axes, with the link turned at random
constexpr char kAabbAtJoints[] = "aabb_joints";  ///< with the joints at random; not timed
constexpr char kSphere[] = "sphere";
constexpr char kOrientedBox[] = "obb";
constexpr char kPrepareSphere[] = "sphere_once";
constexpr char kPrepareOrientedBox[] = "obb_once";
constexpr char kOverlapAabb[] = "aabb_overlap";
constexpr char kOverlapSphere[] = "sphere_overlap";

/// One row per robot and name above: `mesh` is the robot, `volume_ratio` the mean over its links of
/// the volume, divided by the mean volume of kAabb of the same link; `vertices` is the number of
/// links; ns are per link, or per pair. Rows of times have no ratio and the other way round.
Results measureVolumes(const std::vector<MeasuredRobot>& robots, bool is_quick);

}  // namespace link_bounds::bench

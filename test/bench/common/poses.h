// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Under which poses boxes are measured; the same in every run.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace link_bounds::bench {

/// World from mesh, rigid, at most some metres from the origin.
using Poses = std::vector<Eigen::Affine3d>;

constexpr std::size_t kPoses = 1024;              ///< a power of 2
constexpr std::size_t kRandomPoses = kPoses / 2;  ///< the first ones; boxes are judged under these

/// Rotations at random, then a slow and steady motion.
const Poses& turningPoses();

/// The same translations under one rotation.
const Poses& slidingPoses();

/// Rotations at random, without end.
Poses randomPoses(std::size_t count);

}  // namespace link_bounds::bench

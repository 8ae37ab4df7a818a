// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a base can come until it stands: the root in the fixed frame, or the child of a floating or
// planar joint.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/stopping/moving_link.h"
#include "world/model/parameters.h"
#include "world/stopping/edge_samples.h"

namespace link_bounds {

/// Nothing for a base that stands.
struct BaseMotion {
  std::optional<MovingJoint> joint;  ///< in the frame of the poses
  double more = 0;                   ///< how far it may go beside that, in any direction [m]
  std::string problem;               ///< with the remedy
};

/// The base keeps its speed for ~reaction_time and then brakes at least as hard as
/// ~base_deceleration says. Seen from the base, its path keeps the direction it has: so in the
/// frame of the poses it deviates by no more than the base turns. `poses` are those of a window.
BaseMotion baseMotion(const std::vector<TimedPose>& poses, std::int64_t window,
                      const Parameters& parameters);

/// Covers both motions of one base, of which `other` is as seen in a frame that has the pose
/// `frame`.
BaseMotion around(BaseMotion motion, const BaseMotion& other, const Eigen::Isometry3d& frame);

/// The poses of `source` in `target` during the window, at all stamps at which an edge between them
/// has a transform; or why its speed is not known.
EdgeSamples pathSamples(const TransformBuffer& tf, TransformBuffer::Frame target,
                        TransformBuffer::Frame source, std::int64_t stamp, std::int64_t window);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a base can move until it stands. A base is the root in the fixed frame, or the child of a
// floating or planar joint.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/stopping/moving_link.h"
#include "world/model/parameters.h"
#include "world/stopping/edge_samples.h"

namespace link_bounds {

/// The motion of a base until it stands. Without `joint` and `problem` it stands already.
struct BaseMotion {
  std::optional<MovingJoint> joint;  ///< in the frame of the poses
  double more = 0;                   ///< additional distance in any direction [m]
  std::string problem;               ///< why the motion is not known, with the remedy
};

/// Assumes that the base keeps its speed for ~reaction_time and then brakes with at least
/// ~base_deceleration, and that the direction of its path in its own frame stays constant. So in
/// the frame of the poses, the direction changes by at most the angle by which the base turns.
/// `poses` are those of a window of length `window` [ns].
BaseMotion baseMotion(const std::vector<TimedPose>& poses, std::int64_t window,
                      const Parameters& parameters);

/// A motion that covers both motions of one base. `other` is expressed in a frame; `frame` is the
/// pose of that frame in the frame of `motion`.
BaseMotion around(BaseMotion motion, const BaseMotion& other, const Eigen::Isometry3d& frame);

/// The poses of `source` in `target` during the window, at both its ends and at all stamps at which
/// an edge between both frames has a transform; or why the speed is not known.
EdgeSamples pathSamples(const TransformBuffer& tf, TransformBuffer::Frame target,
                        TransformBuffer::Frame source, std::int64_t stamp, std::int64_t window);

}  // namespace link_bounds

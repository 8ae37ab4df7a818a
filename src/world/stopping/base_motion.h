// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds the motion of a base until it stands. A base is the robot's root in the fixed frame, or
// the child of a floating or planar joint.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/stopping/moving_link.h"
#include "world/model/parameters.h"
#include "world/stopping/edge_samples.h"

namespace link_bounds {

/// The possible motion of a base until it stands. Without `joint`, the base stands already.
struct BaseMotion {
  std::optional<MovingJoint> joint;  ///< in the frame of the poses
  double more = 0;                   ///< distance in any direction, in addition [m]
  std::string problem;               ///< why the motion is not known, with the remedy
};

/// The base keeps its speed for ~reaction_time and then brakes by at least ~base_deceleration. Seen
/// from the base, its direction of travel is constant. So in the frame of the poses, this direction
/// changes by at most the turn of the base. `poses` are those of a window.
BaseMotion baseMotion(const std::vector<TimedPose>& poses, std::int64_t window,
                      const Parameters& parameters);

/// Covers both motions of one base. `other` is expressed in another frame; `frame` is the pose of
/// that frame in the frame of `motion`.
BaseMotion around(BaseMotion motion, const BaseMotion& other, const Eigen::Isometry3d& frame);

/// The poses of `source` in `target` at both ends of the window, and at all stamps within it at
/// which an edge between the two frames has a transform; or why the speed is not known.
EdgeSamples pathSamples(const TransformBuffer& tf, TransformBuffer::Frame target,
                        TransformBuffer::Frame source, std::int64_t stamp, std::int64_t window);

}  // namespace link_bounds

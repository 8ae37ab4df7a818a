// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How near two bodies came during one motion. The second body moves in the frame of the first one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "link_bounds/geometry/distance/body_distance.h"
#include "world/history/motion_path.h"

namespace link_bounds {

/// What is proven is at most so far from the nearest pose that was looked at [m], where that is
/// farther away. Of a pair that is not below the limit, all motions are proven to stay there.
constexpr double kPairAccuracy = 1e-3;

/// A body that moves with a frame of tf.
struct FramedBody {
  const Body* body = nullptr;  ///< null until it is measured
  TransformBuffer::Frame frame = 0;
  const Eigen::Affine3d* offset = nullptr;  ///< of the body in that frame; null: none
  double radius = 0;                        ///< about the origin of the frame [m]
};

/// Between poses of their frames. Nothing if it is above `limit`.
std::optional<BodyDistance> distanceOf(const FramedBody& first, const Eigen::Affine3d& first_pose,
                                       const FramedBody& second, const Eigen::Affine3d& second_pose,
                                       double limit);

struct PairFinding {
  double clearance;  ///< proven: they never came nearer [m]
  std::optional<std::int64_t>
      nearest_stamp;      ///< of the nearest pose that was looked at, if any was
  std::string undecided;  ///< why they may have come nearer than `wanted`; "" if they did not
};

/// Clearances above `wanted` are not refined; while no pose is below `limit`, none between two
/// poses may be, either. Such a search is expensive: a bound of the way decides most motions.
PairFinding searchPair(const TransformBuffer& tf, const FramedBody& first, const FramedBody& second,
                       MotionSpan span, double wanted, double limit,
                       const std::function<bool()>& gives_up);

}  // namespace link_bounds

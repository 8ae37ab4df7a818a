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

/// Max gap between the proven clearance and the nearest pose that was examined, if that pose is
/// farther away than this [m]. If no pose is below the limit, all motions are proven to stay above
/// it.
constexpr double kPairAccuracy = 1e-3;

/// A body that moves with a frame of tf.
struct FramedBody {
  const Body* body = nullptr;  ///< null until it is measured
  TransformBuffer::Frame frame = 0;
  const Eigen::Affine3d* offset = nullptr;  ///< pose of the body in that frame; null: identity
  double radius = 0;                        ///< about the origin of the frame [m]
};

/// The distance of two bodies at poses of their frames; std::nullopt if it is above `limit` [m].
std::optional<BodyDistance> distanceOf(const FramedBody& first, const Eigen::Affine3d& first_pose,
                                       const FramedBody& second, const Eigen::Affine3d& second_pose,
                                       double limit);

struct PairFinding {
  double clearance;  ///< proven: they never came nearer [m]
  std::optional<std::int64_t>
      nearest_stamp;      ///< stamp of the nearest pose that was examined, if any
  std::string undecided;  ///< why they may have come nearer than `wanted`; "" if they did not
};

/// Clearances above `wanted` [m] are not refined. Once a pose is below `limit` [m], a clearance
/// just below the nearest pose is enough, too. The search is expensive: a bound on the way decides
/// most motions without it.
PairFinding searchPair(const TransformBuffer& tf, const FramedBody& first, const FramedBody& second,
                       MotionSpan span, double wanted, double limit,
                       const std::function<bool()>& gives_up);

}  // namespace link_bounds

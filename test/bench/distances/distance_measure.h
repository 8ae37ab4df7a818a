// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times methods that find distances.
#pragma once

#include "bench/distances/distance_methods.h"

namespace link_bounds::bench {

/// One method on one robot, or on one generated body, in one motion.
struct DistanceRow {
  std::string robot, motion, method, level;
  /// "near": pairs that are proven to be within the limit. "all": every pair. "update": all pairs
  /// of a pose and the limit, with the poses. "generated": two bodies of that many triangles.
  std::string which;
  std::size_t pairs;                   ///< that were timed
  std::vector<double> ns = {};         ///< per pair; of "update": of all pairs together
  std::vector<double> ns_beside = {};  ///< of ours, for the same pairs and poses as `ns`
  std::optional<std::size_t> triangles = {};
};

using DistanceRows = std::vector<DistanceRow>;

/// Each pair by each method. Ours is the judge of the peers: where one is not within its proven
/// bounds, a line says so.
DistanceRows measurePairs(const DistanceRobot& robot, const std::vector<DistanceSetting>& settings);

/// All pairs of a pose together, by ours.
DistanceRows measureUpdates(const DistanceRobot& robot);

/// Ours and the peers' time for two equal bodies of 1,000 to 200,000 triangles, at the hull level.
DistanceRows measureGrowth(const std::vector<DistanceSetting>& settings, bool quick);

}  // namespace link_bounds::bench

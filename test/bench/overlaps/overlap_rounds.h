// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs all methods on one scene, in turn.
#pragma once

#include <string>
#include <vector>

#include "bench/overlaps/overlap_methods.h"

namespace link_bounds::bench {

/// One method on one scene.
struct OverlapResult {
  std::string method;
  std::string setting;
  std::string scene;
  std::size_t boxes = 0;
  std::size_t pairs = 0;             ///< in the last step
  std::vector<double> us_per_round;  ///< per step; one for each round
};

using OverlapResults = std::vector<OverlapResult>;

/// In each round every method takes the same steps; the order of the methods is random. Trial
/// rounds come first and choose the fastest setting of each method. Throws if two methods find
/// different pairs.
OverlapResults measureOverlaps(const std::vector<OverlapSetting>& settings, OverlapScene scene,
                               int rounds);

}  // namespace link_bounds::bench

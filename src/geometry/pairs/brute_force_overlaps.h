// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares every two boxes: what SweepAndPrune must find, in the plainest way. Tests use it.
#pragma once

#include "link_bounds/geometry/pairs/sweep_and_prune.h"

namespace link_bounds {

class BruteForceOverlaps {
 public:
  /// As SweepAndPrune::find().
  const std::vector<BoxPair>& find(const std::vector<Aabb>& boxes, double margin) {
    pairs_.clear();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        const double distance = signedDistance(boxes[i], boxes[j]);
        if (distance <= margin) pairs_.push_back({i, j, distance});
      }
    }
    return pairs_;
  }

 private:
  std::vector<BoxPair> pairs_;
};

}  // namespace link_bounds

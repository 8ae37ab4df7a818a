// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose boxes are near each other: those that a rule compares, and those that it leaves out.
#pragma once

#include <functional>
#include <vector>

#include "link_bounds/geometry/pairs/sweep_and_prune.h"

namespace link_bounds {

/// A body is given by the index of its box.
struct NearPairs {
  std::vector<BoxPair> compared;  ///< sorted by first, then by second, as left_out
  std::vector<BoxPair> left_out;  ///< near, but left out by the rule
  /// By body: whether `left_out` has all of its pairs that are left out.
  std::vector<bool> is_listed;
};

struct NearPairsGoal {
  double margin = 0;           ///< max distance of boxes that are compared [m]
  double left_out_margin = 0;  ///< max distance of boxes that are listed as left out [m], at most
                               ///< `margin`
  std::size_t max_left_out = 0;
};

class NearPairSearch {
 public:
  /// Whether the two bodies, of which the first has the smaller number, are compared.
  using Rule = std::function<bool(std::size_t, std::size_t)>;

  /// Overwrites `result` and reuses its memory. Returns false if `is_over`, which is called now and
  /// then, returned true.
  bool find(
      const std::vector<Aabb>& boxes, const NearPairsGoal& goal, const Rule& rule,
      NearPairs& result, const std::function<bool()>& is_over = [] { return false; });

 private:
  SweepAndPrune search_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs of boxes that may be near, found with some slack, so that they do for a while.
#pragma once

#include <cstddef>

#include "geometry/overlaps/box_sweep.h"

namespace link_bounds {

struct OverlapCandidates {
  std::vector<NumberPair> pairs;  ///< sorted; all that are near, and some that are not

  // What they were found with.
  std::vector<Aabb> boxes;
  double margin = -1;
  double slack = 0;  ///< by which a side of a box may move before they have to be found anew [m]
  std::size_t steps = 0;  ///< for which they have been in use
  double speed = 0;       ///< how far the fastest side moved in a step, last time they were [m]

  SweepBoxes sweep_boxes;
  std::vector<NumberPair> scratch;
};

/// Finds them anew if they have to be.
void update(const std::vector<Aabb>& boxes, double margin, OverlapCandidates& candidates);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes in the order and the precision in which they are swept.
#pragma once

#include <cstdint>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// How many boxes are looked at together.
constexpr std::size_t kSweepLanes = 8;

/// By rising low on the axis of the sweep, which is the first one here; behind them stand
/// kSweepLanes boxes with low NaN, where every sweep ends.
///
/// Coordinates are rounded, but for all boxes alike, so that no two of them change their order. The
/// high sides are moved outward by the margin. So boxes that are near have low <= high, each with
/// the other's, on all three axes.
struct SweepBoxes {
  std::vector<float> low[3];
  std::vector<float> high[3];
  std::vector<std::uint32_t> numbers;  ///< places in the list of boxes

  std::vector<std::uint64_t> order;  ///< memory for sorting
  std::vector<std::uint64_t> scratch;
};

/// `margin` >= 0 [m].
void arrange(const std::vector<Aabb>& boxes, double margin, SweepBoxes& result);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sweep and prune: pairs of boxes that are near in single precision.
#pragma once

#include <algorithm>

#include "geometry/overlaps/sweep_boxes.h"

namespace link_bounds {

/// The places of two boxes in their list, such that pairs sort by the lower one, then the other.
using NumberPair = std::uint64_t;

constexpr int kNumberBits = 32;

inline NumberPair pairOf(std::uint32_t a, std::uint32_t b) {
  return static_cast<NumberPair>(std::min(a, b)) << kNumberBits | std::max(a, b);
}

inline std::uint32_t firstOf(NumberPair pair) {
  return static_cast<std::uint32_t>(pair >> kNumberBits);
}

inline std::uint32_t secondOf(NumberPair pair) {
  return static_cast<std::uint32_t>(pair);
}

/// Each pair once, in any order.
void sweep(const SweepBoxes& boxes, std::vector<NumberPair>& pairs);

/// The same for processors that sweep() knows nothing special about.
void sweepPlain(const SweepBoxes& boxes, std::vector<NumberPair>& pairs);

}  // namespace link_bounds

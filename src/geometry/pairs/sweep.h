// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs of boxes that are near each other along all three axes, found by a sweep along one axis.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/pairs/bucket_sort.h"
#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// The indices of two boxes, the lower one in the upper 32 bits. Pairs sort by the lower index,
/// then by the other one.
using IndexPair = std::uint64_t;

inline IndexPair pairOf(std::uint32_t a, std::uint32_t b) {
  return static_cast<IndexPair>(std::min(a, b)) << 32 | std::max(a, b);
}

inline std::uint32_t firstOf(IndexPair pair) {
  return static_cast<std::uint32_t>(pair >> 32);
}

inline std::uint32_t secondOf(IndexPair pair) {
  return static_cast<std::uint32_t>(pair);
}

/// Keeps its memory from one call to the next.
class Sweep {
 public:
  /// All pairs of boxes whose gap is at most `margin` along each axis, sorted. Coordinates are
  /// rounded to float, which adds a few other pairs and loses none. `margin` >= 0 [m].
  void find(const std::vector<Aabb>& boxes, double margin, std::vector<IndexPair>& pairs);

 private:
  /// Where a box starts along the axis of the sweep.
  struct Start {
    float min;
    std::uint32_t index;   ///< of the box
    std::uint32_t bucket;  ///< rises with min

    bool operator<(const Start& other) const { return min < other.min; }
  };

  /// The intervals of all boxes along one axis, in the order of the starts.
  struct Intervals {
    std::vector<float> min, max;
  };

  void sortStarts(const std::vector<Aabb>& boxes, int axis, double origin);
  void arrange(const std::vector<Aabb>& boxes, int axis, double origin, double margin,
               Intervals& intervals) const;
  void compare(std::vector<IndexPair>& pairs) const;

  std::vector<Start> starts_;
  Intervals along_;      ///< the axis of the sweep
  Intervals across_[2];  ///< the other two axes
  BucketSort<Start> start_sort_;
  BucketSort<IndexPair> pair_sort_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Which of many boxes overlap or are near each other, without comparing all pairs.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// Two boxes, by their positions in the list of boxes.
struct BoxPair {
  std::size_t first;  ///< < second
  std::size_t second;
  double distance;  ///< signedDistance() of the two [m]
};

/// Finds them again and again as they move, come and go. What one search found helps the next one
/// while boxes move little; whatever they do, the result is the same.
class OverlapSearch {
 public:
  OverlapSearch();
  ~OverlapSearch();
  OverlapSearch(OverlapSearch&& other) noexcept;
  OverlapSearch& operator=(OverlapSearch&& other) noexcept;

  /// All pairs with distance <= margin, sorted by first, then by second; valid until the next
  /// search. `margin` is finite and >= 0 [m]; with 0 boxes that touch count. Boxes are finite, not
  /// empty, and fewer than 2^32. Allocates only while there are more boxes or pairs than before.
  const std::vector<BoxPair>& find(const std::vector<Aabb>& boxes, double margin);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace link_bounds

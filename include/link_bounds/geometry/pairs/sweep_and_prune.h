// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// All pairs of boxes that overlap or are near each other, found without comparing every two boxes.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// Two boxes by their indices in the list of boxes.
struct BoxPair {
  std::size_t first;  ///< < second
  std::size_t second;
  double distance;  ///< signedDistance() of the two [m]
};

/// Finds the pairs again whenever the boxes have moved, and also when boxes come or go. The result
/// depends on the boxes alone. A search is faster when no box has moved far since the last one.
/// A moved-from object may only be assigned to or destroyed.
class SweepAndPrune {
 public:
  SweepAndPrune();
  ~SweepAndPrune();
  SweepAndPrune(SweepAndPrune&& other) noexcept;
  SweepAndPrune& operator=(SweepAndPrune&& other) noexcept;

  /// All pairs with distance <= margin, sorted by first, then by second. They are valid until the
  /// next call. `margin` is finite and >= 0 [m]; with 0, boxes that touch count. Boxes are finite,
  /// not empty, and fewer than 2^32. Allocates memory only if there are more boxes or pairs than
  /// in any call before.
  const std::vector<BoxPair>& find(const std::vector<Aabb>& boxes, double margin);

 private:
  class Candidates;
  std::unique_ptr<Candidates> candidates_;
  std::vector<BoxPair> pairs_;
};

}  // namespace link_bounds

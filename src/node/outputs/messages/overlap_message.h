// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes pairs of near boxes into messages.
#pragma once

#include <functional>
#include <vector>

#include "link_bounds/BoxOverlapArray.h"
#include "world/moment/moment_pairs.h"

namespace link_bounds {

/// Fills one message per moment and reuses the memory of earlier messages.
class OverlapFiller {
 public:
  /// Overwrites `message` with the pairs whose boxes are within overlap_margin. `is_over` is called
  /// regularly; if it returns true, fill() stops and returns false.
  bool fill(
      const MomentPtr& moment, MomentPairs& pairs, BoxOverlapArray& message,
      const std::function<bool()>& is_over = [] { return false; });

 private:
  BoxOverlap& nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count);

  std::vector<BoxOverlap> spare_;  ///< unused entries; their strings keep their memory
};

}  // namespace link_bounds

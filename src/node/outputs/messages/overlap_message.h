// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs of near boxes as a message.
#pragma once

#include <functional>
#include <vector>

#include "link_bounds/BoxOverlapArray.h"
#include "world/moment/moment_pairs.h"

namespace link_bounds {

/// Fills messages of one moment after another and reuses their memory.
class OverlapFiller {
 public:
  /// Overwrites `message` with the pairs whose boxes are within overlap_margin. False if `is_over`,
  /// which is asked now and then, said so.
  bool fill(
      const MomentPtr& moment, MomentPairs& pairs, BoxOverlapArray& message,
      const std::function<bool()>& is_over = [] { return false; });

 private:
  BoxOverlap& nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count);

  std::vector<BoxOverlap> spare_;  ///< unused entries, whose strings have memory
};

}  // namespace link_bounds

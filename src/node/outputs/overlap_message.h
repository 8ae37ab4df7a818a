// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs of near boxes as a message.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "link_bounds/BoxOverlapArray.h"
#include "link_bounds/geometry/overlaps/sweep_and_prune.h"
#include "world/moment/snapshot.h"

namespace link_bounds {

/// Searches the boxes of one moment after another and reuses its memory.
class SceneOverlaps {
 public:
  /// Overwrites `message`; reuses its memory. False if `is_over`, which is asked now and then, said
  /// so.
  bool fill(
      const Snapshot& snapshot, BoxOverlapArray& message,
      const std::function<bool()>& is_over = [] { return false; });

 private:
  void collect(const Snapshot& snapshot);
  BoxOverlap& nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count);

  std::vector<Aabb> boxes_;
  std::vector<PairMember> owners_;
  SweepAndPrune search_;
  std::vector<BoxOverlap> spare_;  ///< unused entries, whose strings have memory
};

}  // namespace link_bounds

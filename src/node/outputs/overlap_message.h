// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs of near boxes as a message.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/BoxOverlapArray.h"
#include "link_bounds/geometry/overlaps/sweep_and_prune.h"
#include "node/loading/model.h"

namespace link_bounds {

/// Searches the boxes of one message after another and reuses its memory.
class SceneOverlaps {
 public:
  /// Overwrites `message`; reuses its memory. `boxes` begins with boxes of links, whose indices in
  /// the model `links` gives.
  void fill(const Model& model, const AxisAlignedBoxArray& boxes,
            const std::vector<std::size_t>& links, BoxOverlapArray& message);

 private:
  void collect(const AxisAlignedBoxArray& boxes, const std::vector<std::size_t>& links);
  BoxOverlap& nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count);

  std::vector<Aabb> boxes_;
  std::vector<PairMember> owners_;
  SweepAndPrune search_;
  std::vector<BoxOverlap> spare_;  ///< unused entries, whose strings have memory
};

}  // namespace link_bounds

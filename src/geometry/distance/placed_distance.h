// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two placed bodies, level by level, with what a search leaves for the next one.
#pragma once

#include <vector>

#include "geometry/distance/simplex.h"
#include "geometry/distance/tree_search.h"

namespace link_bounds {

/// What was nearest in a search. The next search of the same two bodies begins there, which saves
/// time if they have not moved far. Only `trees.front` has proven bounds, which become smaller as
/// `moved` grows; the other members just say where to look first.
struct PairMemory {
  bool is_known = false;
  std::uint32_t first_shape = 0;
  std::uint32_t second_shape = 0;
  Simplex simplex;  ///< of the hulls of these shapes, or of their cores
  TreeMemory trees;
  double moved = 0;  ///< how much nearer the bodies may have come since the memory began [m]
};

/// Buffers that searches use one after the other, so that none allocates.
struct SearchRoom {
  struct ShapeIndices {
    std::uint32_t first;
    std::uint32_t second;
    double lower;  ///< proven by the boxes [m]
  };
  std::vector<ShapeIndices> open;
  TreeScratch trees;
};

/// A distance by the boxes of the bodies alone; nothing unless these prove that the bodies are
/// farther apart than `limit`, as most pairs of a robot are. The two points are arbitrary points of
/// the bodies.
std::optional<BodyDistance> distanceBeyond(double limit, const PlacedBody& first,
                                           const PlacedBody& second);

/// `memory` must be new, or of the same two bodies in any poses. `latest` is their motion since the
/// last call with this memory, at rigid poses of both; without it, no bound of the memory is used.
BodyDistance placedDistance(const PlacedBody& first, const PlacedBody& second,
                            const DistanceGoal& goal, PairMemory& memory, SearchRoom& room,
                            const std::optional<RelativeMotion>& latest = std::nullopt);

/// The same distance from the second body to the first.
std::optional<BodyDistance> swapped(std::optional<BodyDistance> distance);

}  // namespace link_bounds

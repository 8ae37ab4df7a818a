// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distances of all near bodies of a snapshot, as messages.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/DistanceArray.h"
#include "link_bounds/geometry/overlaps/sweep_and_prune.h"
#include "node/distances/live_bodies.h"

namespace link_bounds {

struct ComputedDistances {
  std::shared_ptr<const Snapshot> snapshot;  ///< of which they were computed
  DistanceArray array;
  Distance nearest;
  std::array<std::size_t, 3> levels{};  ///< pairs in the array by what decided them
};

/// Not thread-safe; belongs to one thread.
class SceneDistances {
 public:
  explicit SceneDistances(TreeRequests requests) : bodies_(std::move(requests)) {}

  /// Nothing if `is_cancelled` returns true before the end; it is called for each pair.
  std::optional<ComputedDistances> compute(const std::shared_ptr<const Snapshot>& snapshot,
                                           TriangleTrees::Time now,
                                           const std::function<bool()>& is_cancelled);

  TriangleTrees& trees() { return bodies_.trees(); }

 private:
  std::vector<Aabb> boxes_;
  SweepAndPrune search_;
  LiveBodies bodies_;
};

}  // namespace link_bounds

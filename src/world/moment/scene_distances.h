// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distances of all near bodies of a moment, as messages.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "link_bounds/DistanceArray.h"
#include "world/moment/live_bodies.h"
#include "world/moment/moment_pairs.h"
#include "world/moment/pair_heap.h"

namespace link_bounds {

struct ComputedDistances {
  MomentPtr moment;  ///< of which they were computed
  DistanceArray array;
  Distance nearest;
  std::array<std::size_t, 3> levels{};  ///< pairs in the array by what decided them
  std::size_t left_out = 0;             ///< pairs that may be within the limit, see max_pairs

  // The same as in the array, but by indices of the moment's bodies: names need not be unique.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< of each of its distances
  std::vector<bool> is_complete;                           ///< of each body
};

/// Not thread-safe; belongs to one thread.
class SceneDistances {
 public:
  /// Where `are_carried`, a pair of bodies that have moved little is not searched, see
  /// BodyDistances::follow().
  explicit SceneDistances(TreeRequests requests, bool are_carried = false)
      : bodies_(std::move(requests)), are_carried_(are_carried) {}

  using Concerns = std::function<bool(std::size_t first, std::size_t second)>;

  /// `pairs` may be shared with other users of the moment. Nothing if `is_cancelled` returns true
  /// before the end; it is called for each pair. Bodies of the moment that do not concern, if that
  /// is given, are not measured, as if they were far apart.
  std::optional<ComputedDistances> compute(const MomentPtr& moment, MomentPairs& pairs,
                                           TriangleTrees::Time now,
                                           const std::function<bool()>& is_cancelled,
                                           const Concerns& concerns = {});

  TriangleTrees& trees() { return bodies_.trees(); }

  /// As of the last moment.
  const LiveBodies& bodies() const { return bodies_; }

 private:
  bool findCandidates(const MomentPtr& moment, MomentPairs& pairs,
                      const std::function<bool()>& is_cancelled, const Concerns& concerns);
  std::optional<BodyDistance> distanceOf(const BoxPair& pair, const PairHeap& nearest);
  void measure(const BoxPair& pair, double limit, PairHeap& nearest);
  void leaveOut(std::size_t first, std::size_t second);
  ComputedDistances result(const MomentPtr& moment, const std::vector<FoundPair>& pairs) const;
  void addNames(ComputedDistances& result) const;

  LiveBodies bodies_;
  bool are_carried_;
  std::vector<BoxPair> candidates_;     ///< not measured yet, the next one last
  std::vector<BoxPair> not_compared_;   ///< near by their boxes, but left out by the rule of pairs
  std::vector<bool> is_incomplete_;     ///< of the bodies, as the next two
  std::vector<bool> is_compared_;       ///< with any other one
  std::vector<bool> are_pairs_listed_;  ///< all of those that are not compared
  std::size_t left_out_ = 0;
};

}  // namespace link_bounds

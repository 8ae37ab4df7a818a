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
  MomentPtr moment;  ///< from which they were computed
  DistanceArray array;
  Distance nearest;
  std::array<std::size_t, 3> levels{};  ///< number of pairs in the array by Distance::level
  std::size_t left_out = 0;             ///< pairs beyond max_pairs that may be within the limit

  // As in the array, but with indices of the moment's bodies, because names need not be unique.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< one per distance of the array
  std::vector<bool> is_complete;                           ///< one per body of the moment
};

/// Not thread-safe; belongs to one thread.
class SceneDistances {
 public:
  /// With `are_carried`, uses BodyDistances::follow(), which does not search a pair again whose
  /// bodies have moved little.
  explicit SceneDistances(TreeRequests requests, bool are_carried = false)
      : bodies_(std::move(requests)), are_carried_(are_carried) {}

  using Concerns = std::function<bool(std::size_t first, std::size_t second)>;

  /// `pairs` may be shared with other users of the moment. Nothing if `is_cancelled`, which is
  /// called for each pair, returns true before the end. If `concerns` is given, pairs for which it
  /// returns false are not measured, as if they were far apart.
  std::optional<ComputedDistances> compute(const MomentPtr& moment, MomentPairs& pairs,
                                           TriangleTrees::Time now,
                                           const std::function<bool()>& is_cancelled,
                                           const Concerns& concerns = {});

  TriangleTrees& trees() { return bodies_.trees(); }

  /// The bodies of the last moment.
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
  std::vector<BoxPair> candidates_;     ///< pairs to measure; the last one is measured next
  std::vector<BoxPair> not_compared_;   ///< pairs of near boxes for which isPair() is false
  std::vector<bool> is_incomplete_;     ///< one per body, as the next two
  std::vector<bool> is_compared_;       ///< the body is compared with any other one
  std::vector<bool> are_pairs_listed_;  ///< not_compared_ has all such pairs of the body
  std::size_t left_out_ = 0;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest pairs, as many as one message may have.
#pragma once

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {

/// Two bodies by their indices.
struct FoundPair {
  std::size_t first;
  std::size_t second;
  BodyDistance distance;
};

class PairHeap {
 public:
  /// Keeps the `max` nearest of at most `candidates` pairs.
  PairHeap(std::size_t max, std::size_t candidates) : max_(max) {
    pairs_.reserve(std::min(candidates, max + 1));
  }

  bool isFull() const { return pairs_.size() == max_; }

  /// Lower bound of the distance of the farthest pair. The heap must be full.
  double farthest() const { return pairs_.front().distance.lower; }

  /// Adds a pair. If there are then more than `max`, removes the farthest pair and returns it.
  std::optional<FoundPair> add(FoundPair pair) {
    pairs_.push_back(std::move(pair));
    if (isFull()) std::make_heap(pairs_.begin(), pairs_.end(), isNearer);
    if (pairs_.size() <= max_) return std::nullopt;
    std::push_heap(pairs_.begin(), pairs_.end(), isNearer);
    std::pop_heap(pairs_.begin(), pairs_.end(), isNearer);
    FoundPair farthest = std::move(pairs_.back());
    pairs_.pop_back();
    return farthest;
  }

  /// Moves out all pairs, sorted by first, then by second.
  std::vector<FoundPair> take() {
    const auto isBefore = [](const FoundPair& a, const FoundPair& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    };
    if (!std::is_sorted(pairs_.begin(), pairs_.end(), isBefore))
      std::sort(pairs_.begin(), pairs_.end(), isBefore);
    return std::exchange(pairs_, {});
  }

 private:
  static bool isNearer(const FoundPair& a, const FoundPair& b) {
    return std::tie(a.distance.lower, a.first, a.second) <
           std::tie(b.distance.lower, b.first, b.second);
  }

  std::size_t max_;
  std::vector<FoundPair> pairs_;  ///< once full, a heap with the farthest pair first
};

}  // namespace link_bounds

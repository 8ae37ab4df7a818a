// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of one edge during the last ten seconds, by the rules of tf2's TimeCache and
// StaticCache.
//
// tf2::TimeCache allocates memory for every few transforms and copies each one that is read.
// doc/architecture.md says how long an update takes with it.
#pragma once

#include <vector>

#include "world/tf/sample_ring.h"

namespace link_bounds {

/// The transform that tf2 gives at `stamp` [ns], which is between two samples of one parent or at
/// one of them.
Tf2Pose interpolated(const EdgeSample& older, const EdgeSample& newer, std::int64_t stamp);

class EdgeHistory {
 public:
  /// tf2's default [ns]. Samples that are older than the newest one by more than this are refused
  /// or forgotten.
  static constexpr std::int64_t kLength = 10000000000;

  /// A static edge has one sample, which holds at all times. `memory` must outlive this object.
  explicit EdgeHistory(bool is_static,
                       std::pmr::memory_resource& memory = *std::pmr::new_delete_resource())
      : is_static_(is_static), samples_(memory) {}

  /// Times are nanoseconds. False if the sample is refused: its stamp is in the history already or
  /// too old.
  bool insert(std::int64_t stamp, std::size_t parent, const Tf2Pose& parent_from_child) {
    const bool is_newest = !samples_.isEmpty() && stamp > samples_.newest().stamp;
    if (is_static_ || !is_newest) return insertElsewhere({parent_from_child, parent, stamp});
    samples_.push(oldestKept()) = {parent_from_child, parent, stamp};
    return true;
  }

  /// Forgets the samples, unless the edge is static.
  void clear();

  /// Ordered by stamp. Samples before oldestKept() do not count any more.
  const SampleRing& samples() const { return samples_; }

  /// tf2 would have forgotten the samples before this stamp. 0 if there are no samples.
  std::int64_t oldestKept() const {
    return samples_.isEmpty() ? 0 : samples_.newest().stamp - kLength;
  }

  /// The stamp of the oldest sample that is not before oldestKept(). There must be a sample.
  std::int64_t oldestStamp() const { return samples_[samples_.countUntil(oldestKept() - 1)].stamp; }

  /// The transform at that time; at time 0 the newest. Between two samples of one parent it is
  /// interpolated; between samples of two parents it is the older one. Null if the history does not
  /// cover the time. The result may be in `scratch`.
  const EdgeSample* at(std::int64_t stamp, EdgeSample& scratch) const {
    if (samples_.isEmpty()) return nullptr;
    const EdgeSample& newest = samples_.newest();
    if (is_static_ || stamp == 0 || stamp == newest.stamp) return &newest;
    return stamp < newest.stamp ? before(stamp, scratch) : nullptr;
  }

  /// Whether the history has this sample, up to rounding. For a static edge the stamp does not
  /// count.
  bool holds(const EdgeSample& sample) const;

  /// The samples that decide the transforms at all times from `begin` to `end`, the oldest first:
  /// the last one up to `begin`, all between, and the first one from `end` on. Empty if the history
  /// does not cover that time. A static edge has one.
  std::vector<const EdgeSample*> between(std::int64_t begin, std::int64_t end) const;

 private:
  bool insertElsewhere(const EdgeSample& sample);
  bool isRefused(std::int64_t stamp) const;
  bool reachesBefore(std::int64_t stamp) const;
  const EdgeSample* before(std::int64_t stamp, EdgeSample& scratch) const;

  bool is_static_;
  SampleRing samples_;  ///< some may be older than oldestKept()
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What tf keeps of one edge, by the rules of tf2's TimeCache and StaticCache.
//
// Those would do, but take memory from the heap for every few transforms and copy what is read.
#pragma once

#include "node/tf/sample_ring.h"

namespace link_bounds {

class EdgeHistory {
 public:
  /// tf2's default [ns]. What is older than this before the newest sample is refused or forgotten.
  static constexpr std::int64_t kLength = 10000000000;

  /// A static edge has one sample, which is true at all times.
  explicit EdgeHistory(bool is_static) : is_static_(is_static) {}

  /// Times are nanoseconds. False if it is refused: the stamp is there already, or too old.
  bool insert(std::int64_t stamp, std::size_t parent, const Tf2Pose& parent_from_child) {
    const bool is_newest = !samples_.isEmpty() && stamp > samples_.newest().stamp;
    if (is_static_ || !is_newest) return insertElsewhere({parent_from_child, parent, stamp});
    samples_.push(reach()) = {parent_from_child, parent, stamp};
    return true;
  }

  /// Static edges stay.
  void clear();

  /// At that time, interpolated between two samples of one parent, of two parents the older one; at
  /// time 0 the newest. At the times of the oldest and the newest, these as they are. Null if the
  /// history does not reach the time. `scratch` may be used.
  const EdgeSample* at(std::int64_t stamp, EdgeSample& scratch) const {
    if (samples_.isEmpty()) return nullptr;
    const EdgeSample& newest = samples_.newest();
    if (is_static_ || stamp == 0 || stamp == newest.stamp) return &newest;
    return stamp < newest.stamp ? before(stamp, scratch) : nullptr;
  }

 private:
  bool insertElsewhere(const EdgeSample& sample);
  bool isRefused(std::int64_t stamp) const;
  bool reachesBefore(std::int64_t stamp) const;
  const EdgeSample* before(std::int64_t stamp, EdgeSample& scratch) const;

  /// tf2 would have forgotten what is older.
  std::int64_t reach() const { return samples_.isEmpty() ? 0 : samples_.newest().stamp - kLength; }

  bool is_static_;
  SampleRing samples_;  ///< some of the oldest may be out of reach
};

}  // namespace link_bounds

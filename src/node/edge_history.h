// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What tf keeps of one edge, by the rules of tf2's TimeCache and StaticCache.
//
// Those would do, but take memory from the heap for every few transforms and copy what is read.
#pragma once

#include <cstdint>
#include <deque>
#include <memory_resource>

#include "tf2_pose.h"

namespace link_bounds {

/// One transform. Times are nanoseconds.
struct EdgeSample {
  EdgeSample() = default;
  EdgeSample(std::int64_t time, std::size_t parent_frame, const Tf2Pose& pose)
      : stamp(time), parent(parent_frame), parent_from_child(pose) {}

  std::int64_t stamp = 0;
  std::size_t parent = 0;
  Tf2Pose parent_from_child;
};

class EdgeHistory {
 public:
  /// tf2's default. What is older than this before the newest sample is refused or forgotten.
  static constexpr std::int64_t kLength = 10000000000;

  /// A static edge has one sample, which is true at all times.
  EdgeHistory(bool is_static, std::pmr::memory_resource* memory)
      : is_static_(is_static), samples_(memory) {}

  /// False if it is refused: the stamp is there already, or too old.
  bool insert(std::int64_t stamp, std::size_t parent, const Tf2Pose& parent_from_child) {
    const bool is_newest = !samples_.empty() && stamp > samples_.front().stamp;
    if (is_static_ || !is_newest) return insertElsewhere({stamp, parent, parent_from_child});
    samples_.emplace_front(stamp, parent, parent_from_child);
    dropOldest();
    return true;
  }

  /// Static edges stay.
  void clear();

  /// At that time, interpolated between two samples of one parent, of two parents the older one; at
  /// time 0 the newest. Null if the history does not reach the time. `scratch` may be used.
  const EdgeSample* at(std::int64_t stamp, EdgeSample& scratch) const;

 private:
  bool insertElsewhere(const EdgeSample& sample);
  void dropOldest();
  bool isOutOfReach(const EdgeSample& sample) const;
  const EdgeSample* before(std::int64_t stamp, EdgeSample& scratch) const;

  bool is_static_;
  std::pmr::deque<EdgeSample> samples_;  ///< the newest first; some at the end may be out of reach
};

}  // namespace link_bounds

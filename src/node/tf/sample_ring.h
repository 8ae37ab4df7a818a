// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of one edge in the order of their stamps, in blocks of memory that are used in
// turn. A full history takes nothing from the heap, and what is old is not looked at until its
// memory is needed: with a thousand edges it lies in no cache.
#pragma once

#include <array>
#include <cstdint>
#include <list>

#include "node/tf/tf2_pose.h"

namespace link_bounds {

/// One transform.
struct EdgeSample {
  Tf2Pose parent_from_child;
  std::size_t parent = 0;
  std::int64_t stamp = 0;  ///< nanoseconds
};

class SampleRing {
 public:
  bool isEmpty() const { return !newest_; }
  EdgeSample& newest() { return *newest_; }
  const EdgeSample& newest() const { return *newest_; }

  /// Samples there is memory for.
  std::size_t capacity() const { return blocks_.size() * Block().size(); }

  /// Those between which a stamp lies that is before the newest one: not later, and later.
  struct Neighbours {
    const EdgeSample* older;  ///< null if there is none
    const EdgeSample* newer;
  };
  Neighbours neighbours(std::int64_t stamp) const;

  /// The place of a new one, whose stamp must be after the newest one. Some of those whose stamp is
  /// before `dropped_before` may go.
  EdgeSample& push(std::int64_t dropped_before) {
    if (newest_ == end_of_block_) {
      pushBlock(dropped_before);
    } else {
      ++newest_;
    }
    announce();
    return *newest_;
  }

  /// The same for any other stamp.
  EdgeSample& insert(std::int64_t stamp, std::int64_t dropped_before);

  void clear() { *this = SampleRing(); }

 private:
  using Block = std::array<EdgeSample, 7>;

  /// Begins to fetch the place of the next one.
  void announce() const {
    if (newest_ == end_of_block_) {
      __builtin_prefetch(&blocks_.front().front(), 1);
      __builtin_prefetch(&blocks_.front().back().stamp);
    } else {
      __builtin_prefetch(&newest_[1].stamp, 1);
    }
  }

  void pushBlock(std::int64_t dropped_before);
  void release(std::int64_t dropped_before);

  template <class Blocks, class Visit>
  static void walkBack(Blocks& blocks, const EdgeSample* newest, Visit visit);

  std::list<Block> blocks_;  ///< the newest sample is in the last one
  EdgeSample* newest_ = nullptr;
  EdgeSample* end_of_block_ = nullptr;  ///< the last place of that block
  std::uint32_t turns_ = 0;             ///< blocks begun since the last release()
};

}  // namespace link_bounds

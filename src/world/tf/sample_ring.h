// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of one edge in the order of their stamps, in blocks of memory that are reused.
//
// A full history allocates nothing, and old samples are not read until their memory is reused: with
// a thousand edges they are in no cache. With a std::deque, which allocates and frees, an update of
// 50 to 200 links takes 1.6 times as long and misses a target of `scripts/bench pipeline`.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <vector>

#include "world/tf/tf2_pose.h"

namespace link_bounds {

/// One transform.
struct EdgeSample {
  Tf2Pose parent_from_child;
  std::size_t parent = 0;
  std::int64_t stamp = 0;  ///< nanoseconds
};

class SampleRing {
 public:
  /// `memory` must outlive this object.
  explicit SampleRing(std::pmr::memory_resource& memory = *std::pmr::new_delete_resource())
      : memory_(&memory) {}

  bool isEmpty() const { return !newest_; }
  EdgeSample& newest() { return *newest_; }
  const EdgeSample& newest() const { return *newest_; }

  /// The number of samples that the memory has room for.
  std::size_t capacity() const { return blocks_.size() * kPerBlock; }

  /// The number of samples, including old ones that the next samples may overwrite.
  std::size_t size() const {
    return capacity() - static_cast<std::size_t>(end_of_block_ - newest_);
  }

  /// In the order of the stamps: 0 is the oldest one.
  const EdgeSample& operator[](std::size_t i) const { return at(i); }

  /// How many samples have this stamp or an older one.
  std::size_t countUntil(std::int64_t stamp) const;

  /// The samples before and after a stamp that is older than the newest one.
  struct Neighbours {
    const EdgeSample* older;  ///< at the stamp or before it; null if there is none
    const EdgeSample* newer;  ///< after it
  };
  Neighbours neighbours(std::int64_t stamp) const {
    // Nearly always they are in the newest block.
    for (const EdgeSample* newer = newest_; newer > end_of_block_ - (kPerBlock - 1); --newer) {
      if (newer[-1].stamp <= stamp) return {newer - 1, newer};
    }
    const std::size_t count = countUntil(stamp);
    return {count == 0 ? nullptr : &at(count - 1), &at(count)};
  }

  /// The place of a new sample, whose stamp must be after the newest one. Samples with a stamp
  /// before `dropped_before` may be overwritten.
  EdgeSample& push(std::int64_t dropped_before) {
    if (newest_ == end_of_block_) {
      pushBlock(dropped_before);
    } else {
      ++newest_;
    }
    prefetchNext();
    return *newest_;
  }

  /// As push(), for a stamp that is not after the newest one.
  EdgeSample& insert(std::int64_t stamp, std::int64_t dropped_before);

  void clear() { *this = SampleRing(*memory_); }

 private:
  /// With the header of malloc, a block takes 512 bytes.
  static constexpr std::size_t kPerBlock = 7;
  using Block = std::array<EdgeSample, kPerBlock>;
  struct Delete {
    std::pmr::memory_resource* memory;
    void operator()(Block* block) const { memory->deallocate(block, sizeof(Block)); }
  };
  using BlockPtr = std::unique_ptr<Block, Delete>;

  /// The blocks by age: 0 is the oldest one.
  Block& block(std::size_t i) const {
    const std::size_t place = oldest_place_ + i;
    return *blocks_[place < blocks_.size() ? place : place - blocks_.size()];
  }
  EdgeSample& at(std::size_t i) const { return block(i / kPerBlock)[i % kPerBlock]; }

  /// Prefetches the place of the next sample.
  void prefetchNext() const {
    if (newest_ == end_of_block_) {
      __builtin_prefetch(&oldest_->front(), 1);
      __builtin_prefetch(&oldest_->back().stamp);
    } else {
      __builtin_prefetch(&newest_[1].stamp, 1);
    }
  }

  void pushBlock(std::int64_t dropped_before);
  void release(std::int64_t dropped_before);

  std::pmr::memory_resource* memory_;
  std::vector<BlockPtr> blocks_;  ///< a ring: after the last comes the first
  std::size_t oldest_place_ = 0;  ///< index in blocks_; the newest block is before it
  Block* oldest_ = nullptr;       ///< the oldest block
  EdgeSample* newest_ = nullptr;
  EdgeSample* end_of_block_ = nullptr;  ///< the last place in the newest block
  std::uint32_t blocks_begun_ = 0;      ///< since the last release()
};

}  // namespace link_bounds

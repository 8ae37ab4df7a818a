// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The oldest block is reused once all its samples may be dropped.
#include "world/tf/sample_ring.h"

#include <algorithm>

namespace link_bounds {
namespace {

constexpr std::uint32_t kBlocksPerRelease = 16;  // rare: release() reads old samples, in no cache
constexpr std::size_t kMaxReleased = 64;  // blocks at once: many edges may release in one message

}  // namespace

/// Searches from the newest samples backward, because nearly every call asks for one of them. In a
/// history of 10,000 samples it reads about 25.
std::size_t SampleRing::countUntil(std::int64_t stamp) const {
  std::size_t low = 0;
  std::size_t high = size();
  for (std::size_t step = 1; step <= high; step *= 2) {
    if (at(high - step).stamp <= stamp) {
      low = high - step + 1;
      break;
    }
    high -= step;
  }
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (at(middle).stamp <= stamp) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

EdgeSample& SampleRing::insert(std::int64_t stamp, std::int64_t dropped_before) {
  std::size_t later = isEmpty() ? 0 : size() - countUntil(stamp);
  push(dropped_before);
  std::size_t place = size() - 1;
  for (; later > 0; --later, --place)
    at(place) = at(place - 1);
  return at(place);
}

void SampleRing::pushBlock(std::int64_t dropped_before) {
  if (isEmpty() || oldest_->back().stamp >= dropped_before) {
    const auto end = oldest_place_ == 0
                         ? blocks_.end()
                         : blocks_.begin() + static_cast<std::ptrdiff_t>(oldest_place_);
    auto* const made = new (memory_->allocate(sizeof(Block))) Block;
    blocks_.insert(end, BlockPtr(made, Delete{memory_}));
    if (oldest_place_ > 0) ++oldest_place_;
  } else {
    oldest_place_ = oldest_place_ + 1 < blocks_.size() ? oldest_place_ + 1 : 0;
  }
  oldest_ = blocks_[oldest_place_].get();
  Block& newest = block(blocks_.size() - 1);
  newest_ = newest.data();
  end_of_block_ = &newest.back();
  if (++blocks_begun_ == kBlocksPerRelease) release(dropped_before);
}

/// Frees memory that an edge no longer needs because its rate fell. Two spare blocks stay:
/// otherwise an edge that is not quite regular would allocate and free all the time.
void SampleRing::release(std::int64_t dropped_before) {
  constexpr std::size_t kSpared = 2;
  blocks_begun_ = 0;
  std::size_t count = 0;
  while (count < kMaxReleased && count + kSpared + 1 < blocks_.size() &&
         block(count + kSpared).back().stamp < dropped_before)
    ++count;
  if (count == 0) return;
  std::rotate(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(oldest_place_),
              blocks_.end());
  blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(count));
  oldest_place_ = 0;
  oldest_ = blocks_.front().get();
}

}  // namespace link_bounds

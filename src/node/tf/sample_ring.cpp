// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The oldest block is reused once all its samples may be dropped.
#include "node/tf/sample_ring.h"

#include <iterator>

namespace link_bounds {
namespace {

constexpr std::uint32_t kBlocksPerRelease = 16;
constexpr int kMaxReleased = 64;  // blocks at once: a thousand edges may release in one message

}  // namespace

/// Calls visit(sample) from the newest one on until it returns false.
template <class Blocks, class Visit>
void SampleRing::walkBack(Blocks& blocks, const EdgeSample* newest, Visit visit) {
  auto count = static_cast<std::size_t>(newest - blocks.back().data()) + 1;
  for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
    while (count > 0) {
      if (!visit((*block)[--count])) return;
    }
    count = block->size();
  }
}

SampleRing::Neighbours SampleRing::neighbours(std::int64_t stamp) const {
  Neighbours found{nullptr, nullptr};
  walkBack(blocks_, newest_, [&](const EdgeSample& sample) {
    const bool is_later = sample.stamp > stamp;
    (is_later ? found.newer : found.older) = &sample;
    return is_later;
  });
  return found;
}

EdgeSample& SampleRing::insert(std::int64_t stamp, std::int64_t dropped_before) {
  EdgeSample* place = &push(dropped_before);
  walkBack(blocks_, newest_, [&](EdgeSample& sample) {
    if (&sample == newest_) return true;
    if (sample.stamp <= stamp) return false;
    *place = sample;
    place = &sample;
    return true;
  });
  return *place;
}

void SampleRing::pushBlock(std::int64_t dropped_before) {
  if (blocks_.empty() || blocks_.front().back().stamp >= dropped_before) {
    blocks_.emplace_back();
  } else {
    blocks_.splice(blocks_.end(), blocks_, blocks_.begin());
  }
  newest_ = blocks_.back().data();
  end_of_block_ = &blocks_.back().back();
  if (++blocks_begun_ == kBlocksPerRelease) release(dropped_before);
}

/// Frees the memory that an edge does not need since its rate fell. Two blocks are spared:
/// otherwise an edge that is not quite regular would allocate and free all the time.
void SampleRing::release(std::int64_t dropped_before) {
  constexpr std::size_t kSpared = 2;
  blocks_begun_ = 0;
  for (int i = 0; i < kMaxReleased && blocks_.size() > kSpared + 1; ++i) {
    if (std::next(blocks_.begin(), kSpared)->back().stamp >= dropped_before) return;
    blocks_.pop_front();
  }
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The newest sample is nearly always the one that is wanted, and the place of the next.
#include "edge_history.h"

#include <algorithm>

namespace link_bounds {
namespace {

Tf2Pose interpolated(const EdgeSample& older, const EdgeSample& newer, std::int64_t stamp) {
  const double ratio =
      static_cast<double>(stamp - older.stamp) / static_cast<double>(newer.stamp - older.stamp);
  const Tf2Pose& from = older.parent_from_child;
  const Tf2Pose& to = newer.parent_from_child;
  tf2::Vector3 translation;
  translation.setInterpolate3(from.translation(), to.translation(), ratio);
  return {tf2::slerp(from.rotation(), to.rotation(), ratio), translation};
}

bool isLater(const EdgeSample& sample, std::int64_t stamp) {
  return sample.stamp > stamp;
}

}  // namespace

bool EdgeHistory::insertElsewhere(const EdgeSample& sample) {
  if (is_static_) {
    samples_.assign(1, sample);
    return true;
  }
  if (!samples_.empty() && samples_.front().stamp > sample.stamp + kLength) return false;
  const auto place = std::lower_bound(samples_.begin(), samples_.end(), sample.stamp, isLater);
  if (place != samples_.end() && place->stamp == sample.stamp) return false;
  samples_.insert(place, sample);
  return true;
}

/// Not more than two at a time, and those are fetched when the ones before go: by the next insert()
/// the processor would long have had to wait for them.
void EdgeHistory::dropOldest() {
  for (int i = 0; i < 2 && isOutOfReach(samples_.back()); ++i)
    samples_.pop_back();
  if (samples_.size() > 1) __builtin_prefetch(&*std::prev(samples_.end(), 2));
}

/// tf2 would have forgotten it.
bool EdgeHistory::isOutOfReach(const EdgeSample& sample) const {
  return sample.stamp + kLength < samples_.front().stamp;
}

void EdgeHistory::clear() {
  if (!is_static_) samples_.clear();
}

const EdgeSample* EdgeHistory::at(std::int64_t stamp, EdgeSample& scratch) const {
  if (samples_.empty()) return nullptr;
  const EdgeSample& newest = samples_.front();
  if (is_static_ || stamp == 0 || stamp == newest.stamp) return &newest;
  return stamp < newest.stamp ? before(stamp, scratch) : nullptr;
}

const EdgeSample* EdgeHistory::before(std::int64_t stamp, EdgeSample& scratch) const {
  const auto older = std::lower_bound(samples_.begin(), samples_.end(), stamp, isLater);
  if (older == samples_.end() || isOutOfReach(*older)) return nullptr;
  const auto newer = std::prev(older);
  if (older->parent != newer->parent) return &*older;
  scratch = EdgeSample(stamp, older->parent, interpolated(*older, *newer, stamp));
  return &scratch;
}

}  // namespace link_bounds

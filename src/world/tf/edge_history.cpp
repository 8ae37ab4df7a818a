// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The rare cases. Nearly every call inserts after the newest sample or reads it: see the header.
#include "world/tf/edge_history.h"

#include <algorithm>

namespace link_bounds {
namespace {

/// Whether the poses are equal up to rounding; q and -q are the same rotation.
bool isSame(const Tf2Pose& a, const Tf2Pose& b) {
  constexpr double kRounding = 1e-9;
  const double moved = (a.translation() - b.translation()).length();
  const double turned =
      std::min((a.rotation() - b.rotation()).length(), (a.rotation() + b.rotation()).length());
  return moved <= kRounding * (1 + a.translation().length()) && turned <= kRounding;
}

}  // namespace

Tf2Pose interpolated(const EdgeSample& older, const EdgeSample& newer, std::int64_t stamp) {
  const double ratio =
      static_cast<double>(stamp - older.stamp) / static_cast<double>(newer.stamp - older.stamp);
  const Tf2Pose& from = older.parent_from_child;
  const Tf2Pose& to = newer.parent_from_child;
  tf2::Vector3 translation;
  translation.setInterpolate3(from.translation(), to.translation(), ratio);
  return {tf2::slerp(from.rotation(), to.rotation(), ratio), translation};
}

bool EdgeHistory::insertElsewhere(const EdgeSample& sample) {
  if (is_static_ && !samples_.isEmpty()) {
    samples_.newest() = sample;
  } else if (isRefused(sample.stamp)) {
    return false;
  } else {
    samples_.insert(sample.stamp, oldestKept()) = sample;
  }
  return true;
}

bool EdgeHistory::isRefused(std::int64_t stamp) const {
  if (samples_.isEmpty()) return false;
  if (stamp == samples_.newest().stamp || stamp < oldestKept()) return true;
  const EdgeSample* older = samples_.neighbours(stamp).older;
  return older && older->stamp == stamp;
}

bool EdgeHistory::holds(const EdgeSample& sample) const {
  if (samples_.isEmpty()) return false;
  const EdgeSample* known = &samples_.newest();
  if (!is_static_ && sample.stamp < known->stamp) known = samples_.neighbours(sample.stamp).older;
  return known && (is_static_ || known->stamp == sample.stamp) && known->parent == sample.parent &&
         isSame(known->parent_from_child, sample.parent_from_child);
}

void EdgeHistory::clear() {
  if (!is_static_) samples_.clear();
}

bool EdgeHistory::reachesBefore(std::int64_t stamp) const {
  const EdgeSample* before = samples_.neighbours(stamp - 1).older;
  return before && before->stamp >= oldestKept();
}

const EdgeSample* EdgeHistory::before(std::int64_t stamp, EdgeSample& scratch) const {
  const auto [older, newer] = samples_.neighbours(stamp);
  if (!older || older->stamp < oldestKept()) return nullptr;
  if (older->parent != newer->parent) return older;
  if (older->stamp == stamp && !reachesBefore(stamp)) return older;
  scratch = {interpolated(*older, *newer, stamp), older->parent, stamp};
  return &scratch;
}

std::vector<const EdgeSample*> EdgeHistory::between(std::int64_t begin, std::int64_t end) const {
  if (samples_.isEmpty()) return {};
  if (is_static_) return {&samples_.newest()};
  if (samples_.newest().stamp < end) return {};
  const std::size_t count = samples_.countUntil(begin);
  if (count == 0 || samples_[count - 1].stamp < oldestKept()) return {};
  std::vector<const EdgeSample*> found{&samples_[count - 1]};
  for (std::size_t i = count; found.back()->stamp < end; ++i)
    found.push_back(&samples_[i]);
  return found;
}

}  // namespace link_bounds

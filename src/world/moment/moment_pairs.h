// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The near pairs of a moment, searched once for all users.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/pairs/near_pairs.h"
#include "world/moment/moment.h"

namespace link_bounds {

/// Thread-safe. Caches the result for the last moment only.
class MomentPairs {
 public:
  /// Calls read(pairs). NearPairs::compared has all pairs whose boxes are at most `margin` apart
  /// [m] and for which isPair() holds, and maybe some that are farther apart. NearPairs::left_out
  /// has at most max_pairs other pairs within distance_limit. Other threads wait until read()
  /// returns. False if `is_over`, which is called now and then, returned true.
  template <class Read>
  bool read(
      const MomentPtr& moment, double margin, Read&& read,
      const std::function<bool()>& is_over = [] { return false; }) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!prepare(moment, margin, is_over)) return false;
    read(const_cast<const NearPairs&>(pairs_));
    return true;
  }

  /// Sets the largest margin that any user will ask for [m], so that one search suffices.
  void expect(double margin) { expected_ = margin; }

  /// Frees the memory that is kept between moments.
  void freeMemory();

 private:
  bool prepare(const MomentPtr& moment, double margin, const std::function<bool()>& is_over);

  std::mutex mutex_;
  std::atomic<double> expected_{0};
  NearPairSearch search_;  ///< guarded by mutex_, as are all members below
  std::vector<Aabb> boxes_;
  NearPairs pairs_;
  std::weak_ptr<const Moment> moment_;  ///< of pairs_
  double margin_ = 0;                   ///< of pairs_ [m]
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The near pairs of a moment, searched once for all who ask.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/pairs/near_pairs.h"
#include "world/moment/moment.h"

namespace link_bounds {

/// Any thread may call its functions. The only result that is kept is that of the last moment that
/// was asked for; the next one replaces it.
class MomentPairs {
 public:
  /// Calls read(pairs): NearPairs of bodies whose boxes are at most `margin` apart [m], by the rule
  /// of pairs of the moment's model; maybe also some that are farther apart. Those that are left
  /// out are within distance_limit, and at most max_pairs. Meanwhile other threads wait. False if
  /// `is_over`, which is asked now and then, said so.
  template <class Read>
  bool read(
      const MomentPtr& moment, double margin, Read&& read,
      const std::function<bool()>& is_over = [] { return false; }) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!prepare(moment, margin, is_over)) return false;
    read(const_cast<const NearPairs&>(pairs_));
    return true;
  }

  /// The largest margin that anybody will ask for [m], so that one search suffices.
  void expect(double margin) { expected_ = margin; }

  /// Frees the memory that is kept between moments.
  void freeMemory();

 private:
  bool prepare(const MomentPtr& moment, double margin, const std::function<bool()>& is_over);

  std::mutex mutex_;
  std::atomic<double> expected_{0};
  NearPairSearch search_;  ///< this and what follows: guarded by mutex_
  std::vector<Aabb> boxes_;
  NearPairs pairs_;
  std::weak_ptr<const Moment> moment_;  ///< of the pairs; the next one replaces them
  double margin_ = 0;                   ///< of the pairs [m]
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a search over two trees ended. A later search of the same trees, in poses that differ
// little, looks there first.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "geometry/distance/convex_sets.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {

/// A proven lower bound of the distance of parts of two bodies. A later search reduces it by the
/// motion of the bodies since. It takes four bytes, because a search keeps thousands of them.
/// `moved` is how much nearer the bodies may have come since the memory began, the sum over all
/// searches [m].
class CarriedBound {
 public:
  CarriedBound() = default;  ///< 0
  CarriedBound(double lower, double moved) {
    const double sum = std::min(lower + moved, kLargest);
    // Below the sum, whatever rounding does: half an ulp of a float is 2^-24 of it.
    sum_ = static_cast<float>(sum - (kRoundedDown * std::abs(sum) + kUnderflow));
  }

  /// The bound at a later `moved` [m]; may be negative.
  double at(double moved) const { return static_cast<double>(sum_) - moved * kRoundedUp; }

 private:
  static constexpr double kLargest = 1e30;
  static constexpr double kRoundedUp = 1 + 4 * kUnitRoundoff;
  static constexpr double kRoundedDown = 0x1p-23;
  static constexpr double kUnderflow = 1e-40;

  float sum_ = 0;
};

/// A pair of nodes that was proven to be far enough apart.
struct FrontPair {
  static constexpr std::uint32_t kMaxNode = (1u << 31) - 1;  ///< no tree has more nodes

  std::uint32_t first;
  std::uint32_t second : 31;
  std::uint32_t is_along : 1;  ///< 1: `bound` is proven along `normal`, below
  /// In the axes of the body that rests, so that the normal turns with that body. No vector of
  /// Eigen, so that a pair is copied as plain bytes.
  std::array<float, 3> normal;
  CarriedBound bound;

  Eigen::Vector3d direction() const { return {normal[0], normal[1], normal[2]}; }
};
static_assert(std::is_trivially_copyable_v<FrontPair>);

/// The pairs of nodes that a search dropped. Each pair of triangles is in exactly one of them.
class Front {
 public:
  /// A search renews them in place, which saves the time and the memory of a copy, and then calls
  /// begin() or keep().
  std::vector<FrontPair>& pairs() { return pairs_; }

  /// The pairs are from a search that began with the whole trees.
  void begin() {
    largest_ = std::min(kLargest, pairs_.size() * 3 / 2);
    searches_ = 0;
    keep();
  }

  /// The pairs are from a search that began with this front. Such a search divides pairs but never
  /// joins them, so a front that has grown or is old is dropped, and the next search begins with
  /// the whole trees.
  void keep() {
    if (pairs_.size() > largest_ || ++searches_ > kSearches) pairs_.clear();
    if (pairs_.capacity() > kLargest) pairs_.shrink_to_fit();
  }

 private:
  // Time of all pairs of a robot whose joints turn by 0.01 rad per search, mean of 360: kLargest of
  // 2048 takes 27 % more for the PR2's visual meshes, 8192 the same; kSearches of 8 takes up to 8 %
  // more, 24 from 4 % less to 3 % more.
  static constexpr std::size_t kLargest = 4096;  ///< 96 KiB
  static constexpr int kSearches = 16;
  static_assert(kLargest * sizeof(FrontPair) <= 96 * 1024);

  std::vector<FrontPair> pairs_;
  std::size_t largest_ = 0;
  int searches_ = 0;
};

}  // namespace link_bounds

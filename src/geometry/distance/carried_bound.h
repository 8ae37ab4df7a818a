// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A proven distance of parts of two bodies, which a later search uses less what the bodies have
// moved since.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {

/// In four bytes, as a search keeps thousands. `moved` is how much nearer the bodies may have come
/// since the memory began, the sum over all searches [m].
class CarriedBound {
 public:
  CarriedBound() = default;  ///< 0
  CarriedBound(double lower, double moved) {
    const float sum = static_cast<float>(std::min(lower + moved, kLargest));
    sum_ = std::nextafter(sum, -std::numeric_limits<float>::infinity());  // covers all rounding
  }

  /// May be negative.
  double at(double moved) const { return static_cast<double>(sum_) - moved * kRoundedUp; }

 private:
  static constexpr double kLargest = 1e30;
  static constexpr double kRoundedUp = 1 + 4 * kUnitRoundoff;

  float sum_ = 0;
};

}  // namespace link_bounds

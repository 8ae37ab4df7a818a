// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A proven distance of parts of two bodies, which a later search uses less what the bodies have
// moved since.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace link_bounds {

/// In four bytes, of which a search keeps thousands. Each search knows how far the bodies may have
/// come nearer to each other since the memory began, with the sum of all motions before [m].
class CarriedBound {
 public:
  CarriedBound() = default;  ///< 0
  CarriedBound(double lower, double moved) {
    const float sum = static_cast<float>(std::min(lower + moved, kLargest));
    sum_ = std::nextafter(sum, -std::numeric_limits<float>::infinity());  // covers all rounding
  }

  double at(double moved) const { return std::max(0.0, static_cast<double>(sum_) - moved); }

 private:
  static constexpr double kLargest = 1e30;

  float sum_ = 0;
};

}  // namespace link_bounds

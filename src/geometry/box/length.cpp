// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers whose squares would overflow or underflow are scaled by a power of two first, which is
// exact.
#include "link_bounds/geometry/box/length.h"

#include <algorithm>
#include <cmath>

namespace link_bounds {
namespace {

/// If the largest number lies between these, the sum of the squares is below 3e300, and what a
/// square loses to underflow is far below the rounding of the sum, which is at least 1e-240.
constexpr double kSmallest = 1e-120;
constexpr double kLargest = 1e150;
constexpr double kShrink = 0x1p-600;
constexpr double kGrow = 0x1p+600;

double rootOfSquares(double x, double y, double z) {
  return std::sqrt((x * x + y * y) + z * z);
}

}  // namespace

double length(double x, double y, double z) {
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (largest > kSmallest && largest < kLargest) return rootOfSquares(x, y, z);
  const double scale = largest < 1 ? kGrow : kShrink;
  return rootOfSquares(scale * x, scale * y, scale * z) / scale;
}

}  // namespace link_bounds

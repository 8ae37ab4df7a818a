// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Directed rounding, so that no box is smaller than the shape that it bounds.
///
/// With u = 2^-53, every function here is exact when the result is representable and otherwise
/// steps at most one ulp outward. None depends on the processor's rounding mode.
#pragma once

#include <cmath>
#include <limits>

namespace link_bounds {

/// The unit roundoff of double.
constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

inline double nextUp(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity());
}

inline double nextDown(double value) {
  return std::nextafter(value, -std::numeric_limits<double>::infinity());
}

/// a + b rounded to nearest, or one ulp above where that is below the real sum. Both are at most
/// 2^1022.
/// Not inline: the compiler could fuse a product of the caller into one of the additions here, as
/// for ARM and for x86 with FMA, and the steps would then disagree about its value.
double addUp(double a, double b);

/// a + b rounded to nearest, or one ulp below where that is above the real sum.
double addDown(double a, double b);

/// The smallest float that is not below the value; infinite if there is none.
inline float floatUp(double value) {
  constexpr float largest = std::numeric_limits<float>::max();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (value > largest) return infinity;
  if (value <= -largest) return -largest;
  const float nearest = static_cast<float>(value);
  return nearest < value ? std::nextafter(nearest, infinity) : nearest;
}

/// The largest float that is not above the value; infinite if there is none.
inline float floatDown(double value) {
  return -floatUp(-value);
}

}  // namespace link_bounds

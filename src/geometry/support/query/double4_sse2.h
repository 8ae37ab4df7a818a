// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Four doubles as two vectors of SSE2, which every 64-bit x86 has.
#pragma once

#include "geometry/support/query/double2_sse2.h"

#define LINK_BOUNDS_TARGET

namespace link_bounds {
namespace {

struct Double4 {
  static Double4 all(double value) { return {_mm_set1_pd(value), _mm_set1_pd(value)}; }

  static Double4 ofFloats(const float* values) {
    const __m128 floats = _mm_loadu_ps(values);
    return {_mm_cvtps_pd(floats), _mm_cvtps_pd(_mm_movehl_ps(floats, floats))};
  }

  /// Two numbers from each place.
  static Double4 ofPairs(const double* first, const double* second) {
    return {_mm_loadu_pd(first), _mm_loadu_pd(second)};
  }

  /// The last number is repeated.
  static Double4 ofThree(const double* values) {
    return {_mm_loadu_pd(values), _mm_load1_pd(values + 2)};
  }

  Double2 lower() const { return low; }
  Double2 upper() const { return high; }

  Double2 low, high;
};

inline Double4 operator+(Double4 a, Double4 b) {
  return {_mm_add_pd(a.low, b.low), _mm_add_pd(a.high, b.high)};
}

inline Double4 operator-(Double4 a, Double4 b) {
  return {_mm_sub_pd(a.low, b.low), _mm_sub_pd(a.high, b.high)};
}

inline Double4 operator*(Double4 a, Double4 b) {
  return {_mm_mul_pd(a.low, b.low), _mm_mul_pd(a.high, b.high)};
}

inline Double4 operator/(Double4 a, Double4 b) {
  return {_mm_div_pd(a.low, b.low), _mm_div_pd(a.high, b.high)};
}

inline Double4 operator&(Double4 a, Double4 b) {
  return {_mm_and_pd(a.low, b.low), _mm_and_pd(a.high, b.high)};
}

inline Double4 operator^(Double4 a, Double4 b) {
  return {_mm_xor_pd(a.low, b.low), _mm_xor_pd(a.high, b.high)};
}

inline Double4 min(Double4 a, Double4 b) {
  return {_mm_min_pd(a.low, b.low), _mm_min_pd(a.high, b.high)};
}

inline Double4 max(Double4 a, Double4 b) {
  return {_mm_max_pd(a.low, b.low), _mm_max_pd(a.high, b.high)};
}

/// For each half: number `i` of a, then number `j` of b.
template <int i, int j>
inline Double4 pick(Double4 a, Double4 b) {
  return {_mm_shuffle_pd(a.low, b.low, i | j << 1), _mm_shuffle_pd(a.high, b.high, i | j << 1)};
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Four doubles as two vectors of NEON, which every 64-bit ARM has. The same interface as
// double4_sse2.h and double2_sse2.h.
#pragma once

#include <arm_neon.h>

#include "geometry/support/table/direction_fold.h"

#define LINK_BOUNDS_TARGET

namespace link_bounds {
namespace {

using Double2 = float64x2_t;
using Index2 = uint64x2_t;

inline Double2 min(Double2 a, Double2 b) {
  return vminq_f64(a, b);
}

inline Double2 max(Double2 a, Double2 b) {
  return vmaxq_f64(a, b);
}

inline Double2 firsts(Double2 a, Double2 b) {
  return vzip1q_f64(a, b);
}

inline Double2 seconds(Double2 a, Double2 b) {
  return vzip2q_f64(a, b);
}

inline void store(Double2 a, double* values) {
  vst1q_f64(values, a);
}

inline Index2 gridIndices(Double2 shifted) {
  return vshrq_n_u64(vreinterpretq_u64_f64(shifted), kFraction);
}

inline Index2 cellIndices(Double2 columns, Double2 rows, int log2_side) {
  return vaddq_u64(vshlq_u64(gridIndices(rows), vdupq_n_s64(log2_side)), gridIndices(columns));
}

inline unsigned firstOf(Index2 indices) {
  return static_cast<unsigned>(vgetq_lane_u64(indices, 0));
}

inline unsigned secondOf(Index2 indices) {
  return static_cast<unsigned>(vgetq_lane_u64(indices, 1));
}

struct Double4 {
  static Double4 all(double value) { return {vdupq_n_f64(value), vdupq_n_f64(value)}; }

  static Double4 ofFloats(const float* values) {
    const float32x4_t floats = vld1q_f32(values);
    return {vcvt_f64_f32(vget_low_f32(floats)), vcvt_high_f64_f32(floats)};
  }

  static Double4 ofPairs(const double* first, const double* second) {
    return {vld1q_f64(first), vld1q_f64(second)};
  }

  static Double4 ofThree(const double* values) {
    return {vld1q_f64(values), vdupq_n_f64(values[2])};
  }

  Double2 lower() const { return low; }
  Double2 upper() const { return high; }

  Double2 low, high;
};

inline Double4 operator+(Double4 a, Double4 b) {
  return {vaddq_f64(a.low, b.low), vaddq_f64(a.high, b.high)};
}

inline Double4 operator-(Double4 a, Double4 b) {
  return {vsubq_f64(a.low, b.low), vsubq_f64(a.high, b.high)};
}

inline Double4 operator*(Double4 a, Double4 b) {
  return {vmulq_f64(a.low, b.low), vmulq_f64(a.high, b.high)};
}

inline Double4 operator/(Double4 a, Double4 b) {
  return {vdivq_f64(a.low, b.low), vdivq_f64(a.high, b.high)};
}

inline Double2 bitsOf(Index2 bits) {
  return vreinterpretq_f64_u64(bits);
}

inline Index2 bitsOf(Double2 numbers) {
  return vreinterpretq_u64_f64(numbers);
}

inline Double4 operator&(Double4 a, Double4 b) {
  return {bitsOf(vandq_u64(bitsOf(a.low), bitsOf(b.low))),
          bitsOf(vandq_u64(bitsOf(a.high), bitsOf(b.high)))};
}

inline Double4 operator^(Double4 a, Double4 b) {
  return {bitsOf(veorq_u64(bitsOf(a.low), bitsOf(b.low))),
          bitsOf(veorq_u64(bitsOf(a.high), bitsOf(b.high)))};
}

inline Double4 min(Double4 a, Double4 b) {
  return {min(a.low, b.low), min(a.high, b.high)};
}

inline Double4 max(Double4 a, Double4 b) {
  return {max(a.low, b.low), max(a.high, b.high)};
}

template <int i, int j>
Double2 pick(Double2 a, Double2 b) {
  return vcopyq_laneq_f64(vdupq_laneq_f64(a, i), 1, b, j);
}

template <int i, int j>
Double4 pick(Double4 a, Double4 b) {
  return {pick<i, j>(a.low, b.low), pick<i, j>(a.high, b.high)};
}

}  // namespace
}  // namespace link_bounds

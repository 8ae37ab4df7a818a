// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Four doubles as one vector of AVX2. The same interface as double4_sse2.h.
#pragma once

#include "geometry/support/query/double2_sse2.h"

/// Only functions that have this are compiled for AVX2. The rest of the program must not be: its
/// data layout would no longer fit that of other libraries.
#define LINK_BOUNDS_TARGET __attribute__((target("avx2")))

namespace link_bounds {
namespace {

struct Double4 {
  LINK_BOUNDS_TARGET static Double4 all(double value) { return {_mm256_set1_pd(value)}; }

  LINK_BOUNDS_TARGET static Double4 ofFloats(const float* values) {
    return {_mm256_cvtps_pd(_mm_loadu_ps(values))};
  }

  LINK_BOUNDS_TARGET static Double4 ofHalves(__m128d low, __m128d high) {
    return {_mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1)};
  }

  LINK_BOUNDS_TARGET static Double4 ofPairs(const double* first, const double* second) {
    return ofHalves(_mm_loadu_pd(first), _mm_loadu_pd(second));
  }

  /// Reads one number at a time: a read across two writes that were just made would wait for both
  /// to reach the cache.
  LINK_BOUNDS_TARGET static Double4 ofThree(const double* values) {
    return ofHalves(_mm_loadh_pd(_mm_load_sd(values), values + 1), _mm_load1_pd(values + 2));
  }

  LINK_BOUNDS_TARGET Double2 lower() const { return _mm256_castpd256_pd128(all4); }
  LINK_BOUNDS_TARGET Double2 upper() const { return _mm256_extractf128_pd(all4, 1); }

  __m256d all4;
};

LINK_BOUNDS_TARGET inline Double4 operator+(Double4 a, Double4 b) {
  return {_mm256_add_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 operator-(Double4 a, Double4 b) {
  return {_mm256_sub_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 operator*(Double4 a, Double4 b) {
  return {_mm256_mul_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 operator/(Double4 a, Double4 b) {
  return {_mm256_div_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 operator&(Double4 a, Double4 b) {
  return {_mm256_and_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 operator^(Double4 a, Double4 b) {
  return {_mm256_xor_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 min(Double4 a, Double4 b) {
  return {_mm256_min_pd(a.all4, b.all4)};
}

LINK_BOUNDS_TARGET inline Double4 max(Double4 a, Double4 b) {
  return {_mm256_max_pd(a.all4, b.all4)};
}

template <int i, int j>
LINK_BOUNDS_TARGET inline Double4 pick(Double4 a, Double4 b) {
  return {_mm256_shuffle_pd(a.all4, b.all4, (i | j << 1) * 5)};
}

}  // namespace
}  // namespace link_bounds

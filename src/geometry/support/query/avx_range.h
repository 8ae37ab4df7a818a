// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the files in AVX2 share: four points at a time along one direction.
#pragma once

#include <immintrin.h>

#include "link_bounds/geometry/support/point_set.h"

/// Only functions that have this are compiled for AVX2; the rest of the program must not be, its
/// data layout would no longer fit that of other libraries.
#define LINK_BOUNDS_AVX2 __attribute__((target("avx2")))

namespace link_bounds {

/// One row of the linear part, and the range of r . p over what was added.
struct AvxRange {
  LINK_BOUNDS_AVX2 AvxRange(const Directions& rows, int k)
      : r0(_mm256_set1_pd(rows(k, 0))),
        r1(_mm256_set1_pd(rows(k, 1))),
        r2(_mm256_set1_pd(rows(k, 2))) {}

  LINK_BOUNDS_AVX2 __m256d reach(__m256d x, __m256d y, __m256d z) const {
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(r0, x), _mm256_mul_pd(r1, y)),
                         _mm256_mul_pd(r2, z));
  }

  LINK_BOUNDS_AVX2 void include(__m256d reach) {
    low = _mm256_min_pd(low, reach);
    high = _mm256_max_pd(high, reach);
  }

  LINK_BOUNDS_AVX2 __m128d lowPair() const {
    return _mm_min_pd(_mm256_castpd256_pd128(low), _mm256_extractf128_pd(low, 1));
  }

  LINK_BOUNDS_AVX2 __m128d highPair() const {
    return _mm_max_pd(_mm256_castpd256_pd128(high), _mm256_extractf128_pd(high, 1));
  }

  __m256d r0, r1, r2;
  __m256d low, high;
};

}  // namespace link_bounds

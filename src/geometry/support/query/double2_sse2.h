// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two doubles as a vector of SSE2: for the first and last steps of a query, in SSE2 and in AVX2.
#pragma once

#include <immintrin.h>

#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

using Double2 = __m128d;
using Index2 = __m128i;

inline Double2 min(Double2 a, Double2 b) {
  return _mm_min_pd(a, b);
}

inline Double2 max(Double2 a, Double2 b) {
  return _mm_max_pd(a, b);
}

inline Double2 firsts(Double2 a, Double2 b) {
  return _mm_unpacklo_pd(a, b);
}

inline Double2 seconds(Double2 a, Double2 b) {
  return _mm_unpackhi_pd(a, b);
}

inline void store(Double2 a, double* values) {
  _mm_storeu_pd(values, a);
}

/// gridIndex() of direction_fold.h for two directions; only the low bits of each result are valid.
inline Index2 gridIndices(Double2 shifted) {
  return _mm_srli_epi64(_mm_castpd_si128(shifted), kFraction);
}

inline Index2 cellIndices(Double2 columns, Double2 rows, int log2_side) {
  return _mm_add_epi64(_mm_sll_epi64(gridIndices(rows), _mm_cvtsi32_si128(log2_side)),
                       gridIndices(columns));
}

inline unsigned firstOf(Index2 indices) {
  return static_cast<unsigned>(_mm_cvtsi128_si32(indices));
}

inline unsigned secondOf(Index2 indices) {
  return firstOf(_mm_unpackhi_epi64(indices, indices));
}

}  // namespace
}  // namespace link_bounds

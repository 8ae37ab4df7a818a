// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The scan in SSE2 and AVX2: two or four points at a time, whose coordinates are sorted by axis on
// the way; that costs nothing beside the arithmetic.
#ifdef __SSE2__
#include <algorithm>

#include "geometry/support/query/avx_range.h"
#include "geometry/support/query/direction_query_x86.h"
#include "geometry/support/query/point_scan.h"

namespace link_bounds {
namespace {

/// Coordinates of two points by axis.
struct Two {
  explicit Two(const double* xyz) {
    const __m128d x0y0 = _mm_loadu_pd(xyz);
    const __m128d z0x1 = _mm_loadu_pd(xyz + 2);
    const __m128d y1z1 = _mm_loadu_pd(xyz + 4);
    x = _mm_shuffle_pd(x0y0, z0x1, 2);
    y = _mm_shuffle_pd(x0y0, y1z1, 1);
    z = _mm_shuffle_pd(z0x1, y1z1, 2);
  }

  __m128d x, y, z;
};

/// One row and the range of r . p over what was added.
struct SseScan {
  SseScan(const Directions& rows, int k, const Two& two)
      : r0(_mm_set1_pd(rows(k, 0))), r1(_mm_set1_pd(rows(k, 1))), r2(_mm_set1_pd(rows(k, 2))) {
    low = high = reach(two);
  }

  __m128d reach(const Two& two) const {
    return _mm_add_pd(_mm_add_pd(_mm_mul_pd(r0, two.x), _mm_mul_pd(r1, two.y)),
                      _mm_mul_pd(r2, two.z));
  }

  void add(const Two& two) {
    const __m128d next = reach(two);
    low = _mm_min_pd(low, next);
    high = _mm_max_pd(high, next);
  }

  __m128d r0, r1, r2;
  __m128d low, high;
};

/// The same for four points.
struct Four {
  LINK_BOUNDS_AVX2 explicit Four(const double* xyz) {
    const __m256d xy = load(xyz, xyz + 6);
    const __m256d zx = load(xyz + 2, xyz + 8);
    const __m256d yz = load(xyz + 4, xyz + 10);
    x = _mm256_shuffle_pd(xy, zx, 10);
    y = _mm256_shuffle_pd(xy, yz, 5);
    z = _mm256_shuffle_pd(zx, yz, 10);
  }

  LINK_BOUNDS_AVX2 static __m256d load(const double* low, const double* high) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(low)), _mm_loadu_pd(high), 1);
  }

  __m256d x, y, z;
};

struct AvxScan : AvxRange {
  LINK_BOUNDS_AVX2 AvxScan(const Directions& rows, int k, const Four& four) : AvxRange(rows, k) {
    low = high = reachOf(four);
  }

  LINK_BOUNDS_AVX2 __m256d reachOf(const Four& four) const { return reach(four.x, four.y, four.z); }
  LINK_BOUNDS_AVX2 void add(const Four& four) { include(reachOf(four)); }
};

/// From the last points to the first, which are in the rows already; in portions of `step`, of
/// which the last may overlap those.
template <std::size_t step, class Portion, class Row>
inline __attribute__((always_inline)) void addAll(const double* xyz, std::size_t count, Row& row0,
                                                  Row& row1, Row& row2) {
  for (std::size_t i = count - step; i > 0; i -= std::min(step, i)) {
    const Portion portion(xyz + 3 * i);
    row0.add(portion);
    row1.add(portion);
    row2.add(portion);
  }
}

}  // namespace

Extents scanSse2(const double* xyz, std::size_t count, const Directions& directions) {
  const Two first(xyz);
  SseScan row0(directions, 0, first), row1(directions, 1, first), row2(directions, 2, first);
  addAll<2, Two>(xyz, count, row0, row1, row2);
  Extents result;
  finish(row0.low, row1.low, row2.low, row0.high, row1.high, row2.high, result);
  return result;
}

LINK_BOUNDS_AVX2 Extents scanAvx2(const double* xyz, std::size_t count,
                                  const Directions& directions) {
  const Four first(xyz);
  AvxScan row0(directions, 0, first), row1(directions, 1, first), row2(directions, 2, first);
  addAll<4, Four>(xyz, count, row0, row1, row2);
  Extents result;
  finish(row0.lowPair(), row1.lowPair(), row2.lowPair(), row0.highPair(), row1.highPair(),
         row2.highPair(), result);
  return result;
}

}  // namespace link_bounds
#endif

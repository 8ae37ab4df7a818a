// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The query in SSE2, which every 64-bit x86 has, and in AVX2, compiled for it function by function:
// the rest of the program must not be, its data layout would no longer fit that of other libraries.
//
// What costs is not the arithmetic but waiting for it, so there is no branch and no loop on the way
// of a list of eight points, and the three directions go side by side.
#include "direction_query.h"

#ifdef __SSE2__
#include <immintrin.h>

#include "direction_fold.h"

#define LINK_BOUNDS_AVX2 __attribute__((target("avx2")))

namespace link_bounds {
namespace {

using Cell = DirectionTable::Cell;

/// Brings rows and columns together. What is no number became the integer whose only bit is its
/// sign, which `mask` drops.
inline __m128i joined(__m128i column, __m128i row, int grid) {
  const __m128i shift = _mm_cvtsi32_si128(__builtin_ctz(static_cast<unsigned>(grid)));
  const __m128i mask = _mm_set1_epi32(grid * grid - 1);
  return _mm_and_si128(_mm_add_epi32(_mm_sll_epi32(row, shift), column), mask);
}

/// cellOf() of direction_fold.h for two directions, in the first two places of the result.
inline __m128i cellsOf(int grid, __m128d x, __m128d y, __m128d z) {
  const __m128d sign_bit = _mm_set1_pd(-0.0);
  const __m128d norm =
      _mm_add_pd(_mm_add_pd(_mm_andnot_pd(sign_bit, x), _mm_andnot_pd(sign_bit, y)),
                 _mm_andnot_pd(sign_bit, z));
  const __m128d half_grid = _mm_set1_pd(halfGrid(grid));
  const __m128d turned = _mm_xor_pd(half_grid, _mm_and_pd(sign_bit, z));
  const __m128d s = _mm_div_pd(_mm_mul_pd(_mm_add_pd(x, y), turned), norm);
  const __m128d t = _mm_div_pd(_mm_mul_pd(_mm_sub_pd(x, y), turned), norm);
  return joined(_mm_cvttpd_epi32(_mm_add_pd(s, half_grid)),
                _mm_cvttpd_epi32(_mm_add_pd(t, half_grid)), grid);
}

/// Three numbers, read in the portions in which they are usually written: a read across two writes
/// would wait for both to reach the cache.
LINK_BOUNDS_AVX2 inline __m256d column(const double* values) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(values)), _mm_load_sd(values + 2),
                              1);
}

/// The same for four directions.
LINK_BOUNDS_AVX2 inline __m128i cellsOf(int grid, __m256d x, __m256d y, __m256d z) {
  const __m256d sign_bit = _mm256_set1_pd(-0.0);
  const __m256d norm =
      _mm256_add_pd(_mm256_add_pd(_mm256_andnot_pd(sign_bit, x), _mm256_andnot_pd(sign_bit, y)),
                    _mm256_andnot_pd(sign_bit, z));
  const __m256d half_grid = _mm256_set1_pd(halfGrid(grid));
  const __m256d turned = _mm256_xor_pd(half_grid, _mm256_and_pd(sign_bit, z));
  const __m256d s = _mm256_div_pd(_mm256_mul_pd(_mm256_add_pd(x, y), turned), norm);
  const __m256d t = _mm256_div_pd(_mm256_mul_pd(_mm256_sub_pd(x, y), turned), norm);
  return joined(_mm256_cvttpd_epi32(_mm256_add_pd(s, half_grid)),
                _mm256_cvttpd_epi32(_mm256_add_pd(t, half_grid)), grid);
}

/// One row of the linear part, and the range of r . p over what was added.
struct SseRow {
  SseRow(const Directions& rows, int k)
      : r0(_mm_set1_pd(rows(k, 0))), r1(_mm_set1_pd(rows(k, 1))), r2(_mm_set1_pd(rows(k, 2))) {}

  static __m128d pair(const float* values) {
    return _mm_cvtps_pd(
        _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(values))));
  }

  __m128d reach(const PointBlock& block, int lane) const {
    const __m128d xy =
        _mm_add_pd(_mm_mul_pd(r0, pair(block.x + lane)), _mm_mul_pd(r1, pair(block.y + lane)));
    return _mm_add_pd(xy, _mm_mul_pd(r2, pair(block.z + lane)));
  }

  void begin(const Cell& cell) {
    const __m128d first = reach(cell.near[0], 0);
    const __m128d second = reach(cell.near[0], 2);
    low = _mm_min_pd(first, second);
    high = _mm_max_pd(first, second);
    add(cell.near[1]);
  }

  void add(const PointBlock& block) {
    const __m128d first = reach(block, 0);
    const __m128d second = reach(block, 2);
    low = _mm_min_pd(low, _mm_min_pd(first, second));
    high = _mm_max_pd(high, _mm_max_pd(first, second));
  }

  __m128d r0, r1, r2;
  __m128d low, high;
};

struct AvxRow {
  LINK_BOUNDS_AVX2 AvxRow(const double* rows, Eigen::Index stride, int k)
      : r0(_mm256_broadcast_sd(rows + k)),
        r1(_mm256_broadcast_sd(rows + stride + k)),
        r2(_mm256_broadcast_sd(rows + 2 * stride + k)) {}

  LINK_BOUNDS_AVX2 __m256d reach(const PointBlock& block) const {
    const __m256d x = _mm256_cvtps_pd(_mm_loadu_ps(block.x));
    const __m256d y = _mm256_cvtps_pd(_mm_loadu_ps(block.y));
    const __m256d z = _mm256_cvtps_pd(_mm_loadu_ps(block.z));
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(r0, x), _mm256_mul_pd(r1, y)),
                         _mm256_mul_pd(r2, z));
  }

  LINK_BOUNDS_AVX2 void begin(const Cell& cell) {
    const __m256d first = reach(cell.near[0]);
    const __m256d second = reach(cell.near[1]);
    low = _mm256_min_pd(first, second);
    high = _mm256_max_pd(first, second);
  }

  LINK_BOUNDS_AVX2 void add(const PointBlock& block) {
    const __m256d next = reach(block);
    low = _mm256_min_pd(low, next);
    high = _mm256_max_pd(high, next);
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

/// From two values per direction to one, and from -0 to +0.
inline Extents finished(__m128d low0, __m128d low1, __m128d low2, __m128d high0, __m128d high1,
                        __m128d high2) {
  const __m128d zero = _mm_setzero_pd();
  const __m128d low = _mm_min_pd(_mm_unpacklo_pd(low0, low1), _mm_unpackhi_pd(low0, low1));
  const __m128d high = _mm_max_pd(_mm_unpacklo_pd(high0, high1), _mm_unpackhi_pd(high0, high1));
  const __m128d third_low = _mm_min_sd(low2, _mm_unpackhi_pd(low2, low2));
  const __m128d third_high = _mm_max_sd(high2, _mm_unpackhi_pd(high2, high2));
  Extents result;
  _mm_storeu_pd(result.low.data(), _mm_add_pd(low, zero));
  _mm_storeu_pd(result.high.data(), _mm_add_pd(high, zero));
  _mm_store_sd(result.low.data() + 2, _mm_add_sd(third_low, zero));
  _mm_store_sd(result.high.data() + 2, _mm_add_sd(third_high, zero));
  return result;
}

}  // namespace

Extents querySse2(const DirectionTable& table, const Directions& directions) {
  const double* x = directions.data();
  const double* y = x + directions.outerStride();
  const double* z = y + directions.outerStride();
  const __m128i pair = cellsOf(table.grid, _mm_loadu_pd(x), _mm_loadu_pd(y), _mm_loadu_pd(z));
  const __m128i third =
      cellsOf(table.grid, _mm_load1_pd(x + 2), _mm_load1_pd(y + 2), _mm_load1_pd(z + 2));
  const Cell* const cells = table.cells.data();
  const Cell& cell0 = cells[_mm_cvtsi128_si32(pair)];
  const Cell& cell1 = cells[_mm_cvtsi128_si32(_mm_shuffle_epi32(pair, 1))];
  const Cell& cell2 = cells[_mm_cvtsi128_si32(third)];
  SseRow row0(directions, 0), row1(directions, 1), row2(directions, 2);
  row0.begin(cell0);
  row1.begin(cell1);
  row2.begin(cell2);
  const PointBlock* const more = table.more.data();
  if (cell0.count | cell1.count | cell2.count) {
    for (std::uint32_t i = 0; i < cell0.count; ++i)
      row0.add(more[cell0.first + i]);
    for (std::uint32_t i = 0; i < cell1.count; ++i)
      row1.add(more[cell1.first + i]);
    for (std::uint32_t i = 0; i < cell2.count; ++i)
      row2.add(more[cell2.first + i]);
  }
  return finished(row0.low, row1.low, row2.low, row0.high, row1.high, row2.high);
}

LINK_BOUNDS_AVX2 Extents queryAvx2(const DirectionTable& table, const Directions& directions) {
  const Eigen::Index stride = directions.outerStride();
  const double* x = directions.data();
  const __m128i found = cellsOf(table.grid, column(x), column(x + stride), column(x + 2 * stride));
  const Cell* const cells = table.cells.data();
  const Cell& cell0 = cells[_mm_cvtsi128_si32(found)];
  const Cell& cell1 = cells[_mm_extract_epi32(found, 1)];
  const Cell& cell2 = cells[_mm_extract_epi32(found, 2)];
  AvxRow row0(x, stride, 0), row1(x, stride, 1), row2(x, stride, 2);
  row0.begin(cell0);
  row1.begin(cell1);
  row2.begin(cell2);
  const PointBlock* const more = table.more.data();
  if (cell0.count | cell1.count | cell2.count) {
    for (std::uint32_t i = 0; i < cell0.count; ++i)
      row0.add(more[cell0.first + i]);
    for (std::uint32_t i = 0; i < cell1.count; ++i)
      row1.add(more[cell1.first + i]);
    for (std::uint32_t i = 0; i < cell2.count; ++i)
      row2.add(more[cell2.first + i]);
  }
  return finished(row0.lowPair(), row1.lowPair(), row2.lowPair(), row0.highPair(), row1.highPair(),
                  row2.highPair());
}

}  // namespace link_bounds
#endif

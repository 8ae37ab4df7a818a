// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The query in SSE2, which every 64-bit x86 has: two numbers at a time.
#ifdef __SSE2__
#include "geometry/support/query/direction_query_x86.h"

namespace link_bounds {
namespace {

/// cellOf() of direction_fold.h for two directions; the low bits of each result count.
inline __m128i cellsOf(const DirectionGrid& grid, __m128d x, __m128d y, __m128d z) {
  const __m128d sign_bit = _mm_set1_pd(-0.0);
  const __m128d norm =
      _mm_add_pd(_mm_add_pd(_mm_andnot_pd(sign_bit, x), _mm_andnot_pd(sign_bit, y)),
                 _mm_andnot_pd(sign_bit, z));
  const __m128d turned = _mm_xor_pd(_mm_set1_pd(grid.half), _mm_and_pd(sign_bit, z));
  const __m128d s = _mm_div_pd(_mm_mul_pd(_mm_add_pd(x, y), turned), norm);
  const __m128d t = _mm_div_pd(_mm_mul_pd(_mm_sub_pd(x, y), turned), norm);
  const __m128d shifter = _mm_set1_pd(grid.half + kShifter);
  const __m128i columns = _mm_srli_epi64(_mm_castpd_si128(_mm_add_pd(s, shifter)), kFraction);
  const __m128i rows = _mm_srli_epi64(_mm_castpd_si128(_mm_add_pd(t, shifter)), kFraction);
  return _mm_add_epi64(_mm_sll_epi64(rows, _mm_cvtsi32_si128(grid.log2_side)), columns);
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

void find(const DirectionTable& table, const Directions& directions, CellsOfRows& cells) {
  const double* x = directions.data();
  const double* y = x + directions.outerStride();
  const double* z = y + directions.outerStride();
  const __m128i pair = cellsOf(table.grid, _mm_loadu_pd(x), _mm_loadu_pd(y), _mm_loadu_pd(z));
  const __m128i third =
      cellsOf(table.grid, _mm_load1_pd(x + 2), _mm_load1_pd(y + 2), _mm_load1_pd(z + 2));
  cells = {cellAt(table, pair), cellAt(table, _mm_unpackhi_epi64(pair, pair)),
           cellAt(table, third)};
}

void scan(const DirectionTable& table, const Directions& directions, const CellsOfRows& cells,
          Extents& result) {
  SseRow row0(directions, 0), row1(directions, 1), row2(directions, 2);
  scanRows(table, cells, row0, row1, row2);
  finish(row0.low, row1.low, row2.low, row0.high, row1.high, row2.high, result);
}

Extents findAndScan(const DirectionTable& table, const Directions& directions) {
  CellsOfRows cells;
  find(table, directions, cells);
  Extents result;
  scan(table, directions, cells, result);
  return result;
}

}  // namespace

const Query kSse2Query{QueryPath::kSse2, findAndScan, find, scan};

}  // namespace link_bounds
#endif

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The query in AVX2: four numbers at a time.
#ifdef __SSE2__
#include "geometry/support/query/avx_range.h"
#include "geometry/support/query/direction_query_x86.h"

namespace link_bounds {
namespace {

/// Three numbers, read one by one: a read across two writes that were just made would wait for both
/// to reach the cache.
LINK_BOUNDS_AVX2 inline __m256d load3(const double* values) {
  const __m128d first = _mm_loadh_pd(_mm_load_sd(values), values + 1);
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(first), _mm_load_sd(values + 2), 1);
}

/// cellOf() of direction_fold.h for four directions; the low bits of each result count.
LINK_BOUNDS_AVX2 inline __m256i cellsOf(const DirectionGrid& grid, __m256d x, __m256d y,
                                        __m256d z) {
  const __m256d sign_bit = _mm256_set1_pd(-0.0);
  const __m256d norm =
      _mm256_add_pd(_mm256_add_pd(_mm256_andnot_pd(sign_bit, x), _mm256_andnot_pd(sign_bit, y)),
                    _mm256_andnot_pd(sign_bit, z));
  const __m256d turned = _mm256_xor_pd(_mm256_set1_pd(grid.half), _mm256_and_pd(sign_bit, z));
  const __m256d s = _mm256_div_pd(_mm256_mul_pd(_mm256_add_pd(x, y), turned), norm);
  const __m256d t = _mm256_div_pd(_mm256_mul_pd(_mm256_sub_pd(x, y), turned), norm);
  const __m256d shifter = _mm256_set1_pd(grid.half + kShifter);
  const __m256i columns =
      _mm256_srli_epi64(_mm256_castpd_si256(_mm256_add_pd(s, shifter)), kFraction);
  const __m256i rows = _mm256_srli_epi64(_mm256_castpd_si256(_mm256_add_pd(t, shifter)), kFraction);
  return _mm256_add_epi64(_mm256_sll_epi64(rows, _mm_cvtsi32_si128(grid.log2_side)), columns);
}

struct AvxRow : AvxRange {
  using AvxRange::AvxRange;

  LINK_BOUNDS_AVX2 __m256d reachOf(const PointBlock& block) const {
    return reach(_mm256_cvtps_pd(_mm_loadu_ps(block.x)), _mm256_cvtps_pd(_mm_loadu_ps(block.y)),
                 _mm256_cvtps_pd(_mm_loadu_ps(block.z)));
  }

  LINK_BOUNDS_AVX2 void begin(const Cell& cell) {
    low = high = reachOf(cell.near[0]);
    add(cell.near[1]);
  }

  LINK_BOUNDS_AVX2 void add(const PointBlock& block) { include(reachOf(block)); }
};

LINK_BOUNDS_AVX2 void find(const DirectionTable& table, const Directions& directions,
                           CellsOfRows& cells) {
  const double* x = directions.data();
  const double* y = x + directions.outerStride();
  const double* z = y + directions.outerStride();
  const __m256i indices = cellsOf(table.grid, load3(x), load3(y), load3(z));
  const __m128i pair = _mm256_castsi256_si128(indices);
  cells = {cellAt(table, pair), cellAt(table, _mm_unpackhi_epi64(pair, pair)),
           cellAt(table, _mm256_extracti128_si256(indices, 1))};
}

LINK_BOUNDS_AVX2 void scan(const DirectionTable& table, const Directions& directions,
                           const CellsOfRows& cells, Extents& result) {
  AvxRow row0(directions, 0), row1(directions, 1), row2(directions, 2);
  scanRows(table, cells, row0, row1, row2);
  finish(row0.lowPair(), row1.lowPair(), row2.lowPair(), row0.highPair(), row1.highPair(),
         row2.highPair(), result);
}

LINK_BOUNDS_AVX2 Extents findAndScan(const DirectionTable& table, const Directions& directions) {
  CellsOfRows cells;
  find(table, directions, cells);
  Extents result;
  scan(table, directions, cells, result);
  return result;
}

}  // namespace

const Query kAvx2Query{QueryPath::kAvx2, findAndScan, find, scan};

}  // namespace link_bounds
#endif

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the queries for x86 share. What costs is not the arithmetic but waiting for it: so there is
// no branch and no loop on the way of a list of eight points, and three directions go side by side.
#pragma once

#include <immintrin.h>

#include "geometry/support/direction_fold.h"
#include "geometry/support/query/direction_query.h"

namespace link_bounds {

using Cell = DirectionTable::Cell;

/// The cell whose index is in the low bits of the first place.
inline const Cell* cellAt(const DirectionTable& table, __m128i index) {
  return table.cells.data() + (static_cast<unsigned>(_mm_cvtsi128_si32(index)) & table.grid.mask);
}

/// From two values per direction to one, and from -0 to +0.
inline void finish(__m128d low0, __m128d low1, __m128d low2, __m128d high0, __m128d high1,
                   __m128d high2, Extents& result) {
  const __m128d zero = _mm_setzero_pd();
  const __m128d low = _mm_min_pd(_mm_unpacklo_pd(low0, low1), _mm_unpackhi_pd(low0, low1));
  const __m128d high = _mm_max_pd(_mm_unpacklo_pd(high0, high1), _mm_unpackhi_pd(high0, high1));
  const __m128d third_low = _mm_min_sd(low2, _mm_unpackhi_pd(low2, low2));
  const __m128d third_high = _mm_max_sd(high2, _mm_unpackhi_pd(high2, high2));
  _mm_storeu_pd(result.low.data(), _mm_add_pd(low, zero));
  _mm_storeu_pd(result.high.data(), _mm_add_pd(high, zero));
  _mm_store_sd(result.low.data() + 2, _mm_add_sd(third_low, zero));
  _mm_store_sd(result.high.data() + 2, _mm_add_sd(third_high, zero));
}

/// Adds the lists of three cells to three rows. What is beyond the first eight points of a list is
/// rare, so one question is asked for all three.
template <class Row>
inline __attribute__((always_inline)) void scanRows(const DirectionTable& table,
                                                    const CellsOfRows& cells, Row& row0, Row& row1,
                                                    Row& row2) {
  const Cell &cell0 = *cells[0], &cell1 = *cells[1], &cell2 = *cells[2];
  row0.begin(cell0);
  row1.begin(cell1);
  row2.begin(cell2);
  if (!(cell0.count | cell1.count | cell2.count)) return;
  const PointBlock* const more = table.more.data();
  for (std::uint32_t i = 0; i < cell0.count; ++i)
    row0.add(more[cell0.first + i]);
  for (std::uint32_t i = 0; i < cell1.count; ++i)
    row1.add(more[cell1.first + i]);
  for (std::uint32_t i = 0; i < cell2.count; ++i)
    row2.add(more[cell2.first + i]);
}

}  // namespace link_bounds

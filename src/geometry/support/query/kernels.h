// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The queries over four doubles at a time. A file must include its Double4 before this header.
// Latency costs more than arithmetic: so a list of eight points needs no branch and no loop, and
// the three directions are independent of each other.
#pragma once

#include <algorithm>

#include "geometry/support/query/direction_query.h"
#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

using Cell = DirectionTable::Cell;

/// Coordinates of four points by axis.
struct Points4 {
  LINK_BOUNDS_TARGET explicit Points4(const PointBlock& block)
      : x(Double4::ofFloats(block.x)),
        y(Double4::ofFloats(block.y)),
        z(Double4::ofFloats(block.z)) {}

  /// Reads four points and sorts their numbers by axis, which takes no time beside the arithmetic.
  LINK_BOUNDS_TARGET explicit Points4(const double* xyz) {
    const Double4 xy = Double4::ofPairs(xyz, xyz + 6);
    const Double4 zx = Double4::ofPairs(xyz + 2, xyz + 8);
    const Double4 yz = Double4::ofPairs(xyz + 4, xyz + 10);
    x = pick<0, 1>(xy, zx);
    y = pick<1, 0>(xy, yz);
    z = pick<0, 1>(zx, yz);
  }

  Double4 x, y, z;
};

/// One row of the linear part, and the range of r . p over the points that were added.
struct Row {
  LINK_BOUNDS_TARGET Row(const Directions& rows, int k, const Points4& first)
      : r0(Double4::all(rows(k, 0))), r1(Double4::all(rows(k, 1))), r2(Double4::all(rows(k, 2))) {
    low = high = dot(first);
  }

  LINK_BOUNDS_TARGET Double4 dot(const Points4& points) const {
    return (r0 * points.x + r1 * points.y) + r2 * points.z;
  }

  LINK_BOUNDS_TARGET void add(const Points4& points) {
    const Double4 next = dot(points);
    low = min(low, next);
    high = max(high, next);
  }

  LINK_BOUNDS_TARGET Double2 lowPair() const { return min(low.lower(), low.upper()); }
  LINK_BOUNDS_TARGET Double2 highPair() const { return max(high.lower(), high.upper()); }

  Double4 r0, r1, r2;
  Double4 low, high;
};

/// Reduces two values per direction to one, and turns -0 into +0.
LINK_BOUNDS_TARGET inline void finish(const Row& row0, const Row& row1, const Row& row2,
                                      Extents& result) {
  const Double2 zero{};
  const Double2 low0 = row0.lowPair(), low1 = row1.lowPair(), low2 = row2.lowPair();
  const Double2 high0 = row0.highPair(), high1 = row1.highPair(), high2 = row2.highPair();
  const Double2 low = min(firsts(low0, low1), seconds(low0, low1));
  const Double2 high = max(firsts(high0, high1), seconds(high0, high1));
  const Double2 third_low = min(low2, seconds(low2, low2)) + zero;
  const Double2 third_high = max(high2, seconds(high2, high2)) + zero;
  store(low + zero, result.low.data());
  store(high + zero, result.high.data());
  result.low[2] = third_low[0];
  result.high[2] = third_high[0];
}

/// The cell whose index is in the low bits.
LINK_BOUNDS_TARGET inline const Cell* cellAt(const DirectionTable::Lookup& table, unsigned index) {
  return table.cells + (index & table.grid.mask);
}

/// cellOf() of direction_fold.h for three directions.
LINK_BOUNDS_TARGET inline void find(const DirectionTable::Lookup& table,
                                    const Directions& directions, CellsOfRows& cells) {
  const DirectionGrid& grid = table.grid;
  const double* columns = directions.data();
  const Double4 x = Double4::ofThree(columns);
  const Double4 y = Double4::ofThree(columns + directions.outerStride());
  const Double4 z = Double4::ofThree(columns + 2 * directions.outerStride());
  const Double4 sign = Double4::all(-0.0);
  const Double4 norm = ((x ^ (x & sign)) + (y ^ (y & sign))) + (z ^ (z & sign));
  const Double4 turned = Double4::all(grid.half) ^ (z & sign);
  const Double4 shifter = Double4::all(grid.half + kShifter);
  const Double4 s = (x + y) * turned / norm + shifter;
  const Double4 t = (x - y) * turned / norm + shifter;
  const Index2 first_two = cellIndices(s.lower(), t.lower(), grid.log2_side);
  const Index2 third = cellIndices(s.upper(), t.upper(), grid.log2_side);
  cells = {cellAt(table, firstOf(first_two)), cellAt(table, secondOf(first_two)),
           cellAt(table, firstOf(third))};
}

LINK_BOUNDS_TARGET inline void addRest(const DirectionTable::Lookup& table,
                                       const DirectionTable::List* list, Row& row) {
  const auto number = static_cast<std::size_t>(list - table.lists);
  if (number >= table.rest_count) return;
  const DirectionTable::Rest rest = table.rests[number];
  for (std::uint32_t i = 0; i < rest.count; ++i)
    row.add(Points4(table.overflow[rest.first + i]));
}

/// Points beyond the first eight of a list are rare, so one branch serves all three lists.
LINK_BOUNDS_TARGET inline void scan(const DirectionTable::Lookup& table,
                                    const Directions& directions, const ListsOfRows& lists,
                                    Extents& result) {
  Row row0(directions, 0, Points4(lists[0]->blocks[0]));
  Row row1(directions, 1, Points4(lists[1]->blocks[0]));
  Row row2(directions, 2, Points4(lists[2]->blocks[0]));
  row0.add(Points4(lists[0]->blocks[1]));
  row1.add(Points4(lists[1]->blocks[1]));
  row2.add(Points4(lists[2]->blocks[1]));
  if (std::min({lists[0], lists[1], lists[2]}) < table.lists + table.rest_count) {
    addRest(table, lists[0], row0);
    addRest(table, lists[1], row1);
    addRest(table, lists[2], row2);
  }
  finish(row0, row1, row2, result);
}

/// Goes from the last points to the first, in portions of four; the last portion may overlap the
/// first four, which are in the rows already.
LINK_BOUNDS_TARGET inline Extents scanAll(const double* xyz, std::size_t count,
                                          const Directions& directions) {
  const Points4 first(xyz);
  Row row0(directions, 0, first), row1(directions, 1, first), row2(directions, 2, first);
  for (std::size_t i = count - kLanes; i > 0; i -= std::min(kLanes, i)) {
    const Points4 points(xyz + 3 * i);
    row0.add(points);
    row1.add(points);
    row2.add(points);
  }
  Extents result;
  finish(row0, row1, row2, result);
  return result;
}

}  // namespace
}  // namespace link_bounds

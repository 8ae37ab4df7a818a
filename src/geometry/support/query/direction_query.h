// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extents of the points of a table, and of all points of a set.
#pragma once

#include <array>

#include "geometry/support/table/direction_table.h"
#include "link_bounds/geometry/support/query/extents.h"

#if defined(__aarch64__) && !defined(LINK_BOUNDS_PLAIN)
#define LINK_BOUNDS_NEON
#endif

namespace link_bounds {

/// Which instructions the queries use. The best path of this processor is chosen at the first
/// query.
enum class QueryPath { kPlain, kSse2, kAvx2, kNeon };
constexpr QueryPath kQueryPaths[] = {QueryPath::kPlain, QueryPath::kSse2, QueryPath::kAvx2,
                                     QueryPath::kNeon};

bool isSupported(QueryPath path);
QueryPath queryPath();

/// For tests and benchmarks; `path` must be supported.
void useQueryPath(QueryPath path);

/// Extents along the rows of `directions`, which must not exceed 1e30. Each r . p is evaluated as
/// (r0 x + r1 y) + r2 z in double, so the result is the same to the bit on every machine and every
/// path of instructions; a zero is +0.
Extents extents(const DirectionTable& table, const Directions& directions);

/// The cells of three directions, and the lists that these name.
using CellsOfRows = std::array<const DirectionTable::Cell*, 3>;
using ListsOfRows = std::array<const DirectionTable::List*, 3>;

inline ListsOfRows listsOf(const DirectionTable::Lookup& table, const CellsOfRows& cells) {
  return {table.lists + *cells[0], table.lists + *cells[1], table.lists + *cells[2]};
}

/// extents() in three steps. Each of the first two prefetches the data of the next, so with other
/// work in between none waits for memory.
void findCells(const DirectionTable::Lookup& table, const Directions& directions,
               CellsOfRows& cells);
void findLists(const DirectionTable::Lookup& table, const CellsOfRows& cells, ListsOfRows& lists);
void scanLists(const DirectionTable::Lookup& table, const Directions& directions,
               const ListsOfRows& lists, Extents& result);

/// The functions of a query for one instruction set.
struct Query {
  QueryPath path;
  void (*find)(const DirectionTable::Lookup& table, const Directions& directions,
               CellsOfRows& cells);
  void (*scan)(const DirectionTable::Lookup& table, const Directions& directions,
               const ListsOfRows& lists, Extents& result);
  /// Extents of `count` points in double, as for PointSet. All paths but the plain one need at
  /// least kLanes points.
  Extents (*scan_all)(const double* xyz, std::size_t count, const Directions& directions);
};

static_assert(sizeof(PointBlock) == 3 * kLanes * sizeof(float), "a block fills the lanes");

/// The Query that is in use.
const Query& query();

extern const Query kPlainQuery;

#ifdef __SSE2__
extern const Query kSse2Query;
extern const Query kAvx2Query;
#endif
#ifdef LINK_BOUNDS_NEON
extern const Query kNeonQuery;
#endif

// The scan over all points of a set in double; `xyz` and `count` as for PointSet. A list that does
// not fit into the cache is read to and fro, magnitude upwards and extents downwards, so that each
// pass begins where the one before it ended.

/// The largest |x|, |y| and |z|.
Eigen::Vector3d scannedMagnitude(const double* xyz, std::size_t count);

/// As PointSet::extents, by the path in use.
Extents scannedExtents(const double* xyz, std::size_t count, const Directions& directions);

/// The same by the plain path.
Extents scanPlain(const double* xyz, std::size_t count, const Directions& directions);

}  // namespace link_bounds

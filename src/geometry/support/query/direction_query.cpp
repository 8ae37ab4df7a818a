// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The plain path, and the choice among the paths.
#include "geometry/support/query/direction_query.h"

#include <algorithm>
#include <atomic>

#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

/// Smallest and largest dot product of one row with the points so far.
struct Range {
  double low;
  double high;

  void add(const PointBlock& block, double r0, double r1, double r2) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double dot = (r0 * block.x[lane] + r1 * block.y[lane]) + r2 * block.z[lane];
      low = std::min(low, dot);
      high = std::max(high, dot);
    }
  }
};

void find(const DirectionTable::Lookup& table, const Directions& directions, CellsOfRows& cells) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto row = directions.row(static_cast<Eigen::Index>(k));
    cells[k] = &table.cells[cellOf(row[0], row[1], row[2], table.grid)];
  }
}

void scan(const DirectionTable::Lookup& table, const Directions& directions,
          const ListsOfRows& lists, Extents& result) {
  for (int k = 0; k < 3; ++k) {
    const double r0 = directions(k, 0);
    const double r1 = directions(k, 1);
    const double r2 = directions(k, 2);
    const DirectionTable::List* const list = lists[static_cast<std::size_t>(k)];
    const PointBlock(&blocks)[2] = list->blocks;
    const double first = (r0 * blocks[0].x[0] + r1 * blocks[0].y[0]) + r2 * blocks[0].z[0];
    Range range{first, first};
    range.add(blocks[0], r0, r1, r2);
    range.add(blocks[1], r0, r1, r2);
    const auto number = static_cast<std::size_t>(list - table.lists);
    const auto rest = number < table.rest_count ? table.rests[number] : DirectionTable::Rest{0, 0};
    for (std::uint32_t i = 0; i < rest.count; ++i)
      range.add(table.overflow[rest.first + i], r0, r1, r2);
    result.low[k] = range.low + 0.0;
    result.high[k] = range.high + 0.0;
  }
}

QueryPath bestPath() {
  if (isSupported(QueryPath::kAvx2)) return QueryPath::kAvx2;
  if (isSupported(QueryPath::kNeon)) return QueryPath::kNeon;
  return isSupported(QueryPath::kSse2) ? QueryPath::kSse2 : QueryPath::kPlain;
}

const Query& queryBy(QueryPath path) {
#ifdef __SSE2__
  if (path == QueryPath::kSse2) return kSse2Query;
  if (path == QueryPath::kAvx2) return kAvx2Query;
#endif
#ifdef LINK_BOUNDS_NEON
  if (path == QueryPath::kNeon) return kNeonQuery;
#endif
  static_cast<void>(path);
  return kPlainQuery;
}

/// Null until a path is chosen.
std::atomic<const Query*> chosen_query{nullptr};

}  // namespace

const Query kPlainQuery{QueryPath::kPlain, find, scan, scanPlain};

const Query& query() {
  const Query* const chosen = chosen_query.load(std::memory_order_relaxed);
  if (chosen) return *chosen;
  useQueryPath(bestPath());
  return queryBy(bestPath());
}

bool isSupported(QueryPath path) {
#ifdef __SSE2__
  if (path == QueryPath::kSse2) return true;
  if (path == QueryPath::kAvx2) return __builtin_cpu_supports("avx2");
#endif
#ifdef LINK_BOUNDS_NEON
  if (path == QueryPath::kNeon) return true;
#endif
  return path == QueryPath::kPlain;
}

QueryPath queryPath() {
  return query().path;
}

void useQueryPath(QueryPath path) {
  chosen_query.store(&queryBy(path), std::memory_order_relaxed);
}

Extents extents(const DirectionTable& table, const Directions& directions) {
  const DirectionTable::Lookup lookup = table.lookup();
  CellsOfRows cells;
  query().find(lookup, directions, cells);
  Extents result;
  query().scan(lookup, directions, listsOf(lookup, cells), result);
  return result;
}

void findCells(const DirectionTable::Lookup& table, const Directions& directions,
               CellsOfRows& cells) {
  query().find(table, directions, cells);
  for (const DirectionTable::Cell* cell : cells)
    __builtin_prefetch(cell);
}

void findLists(const DirectionTable::Lookup& table, const CellsOfRows& cells, ListsOfRows& lists) {
  lists = listsOf(table, cells);
  for (const DirectionTable::List* list : lists) {
    __builtin_prefetch(&list->blocks[0].x);
    __builtin_prefetch(&list->blocks[1].z);
  }
}

void scanLists(const DirectionTable::Lookup& table, const Directions& directions,
               const ListsOfRows& lists, Extents& result) {
  query().scan(table, directions, lists, result);
}

}  // namespace link_bounds

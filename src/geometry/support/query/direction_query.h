// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One query in the instructions of one processor; which file has them is all that differs.
#pragma once

#include "link_bounds/geometry/support/direction_table.h"

namespace link_bounds {

/// What extents() does by one path, and its two halves.
struct Query {
  QueryPath path;
  Extents (*both)(const DirectionTable& table, const Directions& directions);
  void (*find)(const DirectionTable& table, const Directions& directions, CellsOfRows& cells);
  void (*scan)(const DirectionTable& table, const Directions& directions, const CellsOfRows& cells,
               Extents& result);
};

extern const Query kPlainQuery;

#ifdef __SSE2__
extern const Query kSse2Query;
extern const Query kAvx2Query;
#endif

}  // namespace link_bounds

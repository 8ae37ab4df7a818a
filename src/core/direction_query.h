// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One query in the instructions of one processor; which file has them is all that differs.
#pragma once

#include "link_bounds/direction_table.h"

namespace link_bounds {

/// What extents() does, by one path.
using Query = Extents (*)(const DirectionTable& table, const Directions& directions);

Extents queryPlain(const DirectionTable& table, const Directions& directions);

#ifdef __SSE2__
Extents querySse2(const DirectionTable& table, const Directions& directions);
Extents queryAvx2(const DirectionTable& table, const Directions& directions);
#endif

}  // namespace link_bounds

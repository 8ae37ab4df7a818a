// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reports times of overlap searches, and whether they reach their targets.
#pragma once

#include "bench/common/row.h"
#include "bench/overlaps/overlap_rounds.h"

namespace link_bounds::bench {

/// Prints the table and the targets; returns the rows.
Rows reportOverlaps(const OverlapResults& results);

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reports times of overlap searches, and whether they reach their targets.
#pragma once

#include <iosfwd>

#include "bench/overlaps/overlap_rounds.h"

namespace link_bounds::bench {

void printOverlaps(const OverlapResults& results, std::ostream& out);
void printOverlapTargets(const OverlapResults& results, std::ostream& out);

/// An array with one object per result.
void writeOverlapJson(const OverlapResults& results, std::ostream& out);

}  // namespace link_bounds::bench

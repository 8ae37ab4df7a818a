// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Verdicts about pairs of links as a SRDF.
#pragma once

#include <ostream>

#include "tools/urdf_bounds/pairs/pairs_table.h"

namespace link_bounds {

/// What is proven, as elements, or as the SRDF of the table with these and with those of its own
/// that are not refuted. `accept_sampled`: also pairs that collided in all poses that were tried.
void writeSrdf(const PairsTable& table, bool accept_sampled, std::ostream& out);

/// For people: the pairs without an element because they are not decided.
void writeUndecided(const PairsTable& table, std::ostream& out);

}  // namespace link_bounds

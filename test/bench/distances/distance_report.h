// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reports times of distances, and whether they reach their targets.
#pragma once

#include "bench/common/table.h"
#include "bench/distances/distance_measure.h"

namespace link_bounds::bench {

Row rowOf(const DistanceRow& row);

/// The columns of these rows.
Table distanceTable();

/// `bytes_per_triangle`: of each robot.
void printDistanceTargets(const Rows& rows, const std::vector<double>& bytes_per_triangle);

}  // namespace link_bounds::bench

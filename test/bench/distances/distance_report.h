// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reports times of distances, and whether they reach their targets.
#pragma once

#include <iosfwd>

#include "bench/distances/distance_measure.h"

namespace link_bounds::bench {

/// One line.
void print(const DistanceRow& row, std::ostream& out);

/// `bytes_per_triangle`: of each robot.
void printDistanceTargets(const DistanceRows& rows, const std::vector<double>& bytes_per_triangle,
                          std::ostream& out);

/// An array with one object per row.
void writeDistanceJson(const DistanceRows& rows, std::ostream& out);

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and distances of one pose or of many.
#pragma once

#include <pybind11/numpy.h>

#include "python/shared_robot.h"

namespace link_bounds {

/// Makes the type of what distancesOf() returns known to NumPy; once, before it is called.
void registerPairRow();

/// [links, 2, 3], or [rows, links, 2, 3]. `jobs` threads; 0: one per core.
pybind11::array boxesOf(SharedRobot& shared, const pybind11::object& q, unsigned jobs);

/// Pairs of all rows, sorted by row, first and second.
pybind11::array distancesOf(SharedRobot& shared, const pybind11::object& q, double limit,
                            unsigned jobs);

}  // namespace link_bounds

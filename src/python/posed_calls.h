// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and distances of one pose or of many.
#pragma once

#include <pybind11/numpy.h>

#include "python/shared_robot.h"

namespace link_bounds {

/// Registers the entries of distancesOf() as a type of NumPy. Call it once, before distancesOf().
void registerPairRow();

/// Corners as an array [links, 2, 3], or [rows, links, 2, 3]. `jobs` threads; 0: one per core.
pybind11::array boxesOf(SharedRobot& shared, const pybind11::object& q, unsigned jobs);

/// Pairs of all rows, sorted by row, first and second.
pybind11::array distancesOf(SharedRobot& shared, const pybind11::object& q, double limit,
                            unsigned jobs);

}  // namespace link_bounds

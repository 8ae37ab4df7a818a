// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joint values, ranges, names and numbers as users of Python write them. Wrong input raises a
// ValueError that names it.
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "python/shared_robot.h"

namespace link_bounds {

using RowArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Rows with one finite value per joint of SharedRobot::joints(). The array keeps them alive.
struct JointRows {
  RowArray values;
  std::size_t count;  ///< rows
  bool is_single;     ///< one pose was given, not rows of poses

  const double* row(std::size_t number, std::size_t columns) const {
    return values.data() + number * columns;
  }
};

/// Reads a dict {joint: value}, in which missing joints are at 0; an array [joints] in the order of
/// SharedRobot::joints(); an array [rows, joints]; or a list of dicts. An array of doubles in C
/// order is not copied. Errors call it `name`.
JointRows jointRows(const SharedRobot& shared, const pybind11::handle& q,
                    const std::string& name = "q");

/// One value per joint of the robot, from one of the rows; 0 for joints that the rows do not have.
std::vector<double> spread(const SharedRobot& shared, const JointRows& rows, std::size_t row);

/// Reads a dict {joint: value} or {joint: (lower, upper)}; or None.
GivenRanges givenRanges(const SharedRobot& shared, const pybind11::object& ranges);

/// A mapping, which is what has keys(), as a dict. Throws ValueError for other objects; `name` and
/// `what` tell in messages what must be a mapping.
pybind11::dict dictOf(const pybind11::handle& given, const std::string& name, const char* what);

/// The text of a key in a dict. Throws ValueError for other keys than text. `kind` tells in
/// messages what it must be the name of.
std::string keyName(const pybind11::handle& key, const char* kind);

/// Throws ValueError for more threads than any machine has. 0: one per core.
void checkJobs(unsigned jobs);

/// An array of real numbers. Throws ValueError for values of other types, which would be converted
/// without their unit, and for a masked array, whose masked values are invalid. `what` tells in
/// messages what it must be.
pybind11::array numbersOf(const pybind11::handle& given, const std::string& name,
                          const std::string& what);

/// Refuses a number that is not finite, or below 0.
void checkLength(const char* name, double metres);

/// Refuses a number that is not above 0.
void checkPositive(const char* name, double number, const char* unit);

}  // namespace link_bounds

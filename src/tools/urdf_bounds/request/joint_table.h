// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A table of joint values: the csv file of --poses. doc/tools.md describes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Messages number rows from 1; row r is at index r - 1.
struct JointTable {
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<std::size_t> joints;    ///< indices in the robot; the columns of the next three
  Numbers positions;                  ///< rad or m
  Numbers velocities;                 ///< rad/s or m/s; no columns if the file has none
  Numbers accelerations;              ///< rad/s² or m/s²; no columns if the file has none
  std::vector<double> times;          ///< s; empty if the file has no such column
  std::vector<std::string> faults;    ///< why each row cannot be used; "" if it can
  std::vector<std::string> problems;  ///< messages to the user; --strict refuses them
  std::vector<std::string> notes;     ///< messages about correct input that may surprise

  std::size_t rows() const { return faults.size(); }
};

/// Reads a table for a robot with simple joints. `columns` are the names of the columns, separated
/// by commas; without them, the first line of the text has the names. `given` are the joints that
/// need no column. Throws UsageError with the name of `file` if no row can be used or a column
/// occurs twice. For a path, also throws if an unknown column may belong to a joint, such as a
/// velocity with another name.
JointTable parseJointTable(const std::string& text, const std::string& file,
                           const std::optional<std::string>& columns, const Robot& robot,
                           const std::vector<std::string>& given, bool is_path);

/// One value per joint of the robot [rad or m].
using JointValues = std::vector<double>;

/// Reads the file of --poses and warns of its problems. `simple` has simple joints. `given` has the
/// values from the command line. Throws UsageError; with --strict also for the first problem.
JointTable readJointTable(const UrdfBoundsOptions& options, const Robot& simple,
                          const JointValues& given);

/// Warns of each problem; with --strict throws UsageError for the first one.
void tellProblems(const UrdfBoundsOptions& options, const std::vector<std::string>& problems);

/// The joint values of the row at index `row`; joints without a column keep their value in `given`.
JointValues valuesOf(const JointTable& table, std::size_t row, JointValues given);

}  // namespace link_bounds

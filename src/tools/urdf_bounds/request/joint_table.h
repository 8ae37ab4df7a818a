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

/// Rows are numbered from 1; row r is at index r - 1.
struct JointTable {
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<std::size_t> joints;    ///< of the robot; the columns of the next three
  Numbers positions;                  ///< rad or m
  Numbers velocities;                 ///< per s; without columns where the file has none
  Numbers accelerations;              ///< per s²; without columns where the file has none
  std::vector<double> times;          ///< s; empty where the file has no such column
  std::vector<std::string> faults;    ///< of each row why it cannot be used; "" = it can
  std::vector<std::string> problems;  ///< in words, each names the column, and the first row
  std::vector<std::string> notes;     ///< what is right, but may surprise

  std::size_t rows() const { return faults.size(); }
};

/// Robots are those with simple joints. `columns` are the names of the columns, separated by
/// commas; none: they are the first line of the text. `given` are the joints that need no column.
/// Throws UsageError, which names `file`, where no row can be used, where a column is there twice,
/// and, of a path, where one is of a joint, but not known: it may be a velocity with another name.
JointTable parseJointTable(const std::string& text, const std::string& file,
                           const std::optional<std::string>& columns, const Robot& robot,
                           const std::vector<std::string>& given, bool is_path);

/// What is the same in all rows of a table: the values that the command line gives.
using JointValues = std::vector<double>;

/// Reads the file of --poses, and warns of what is wrong with it. `simple` has simple joints.
/// Throws UsageError; with --strict also where anything is wrong.
JointTable readJointTable(const UrdfBoundsOptions& options, const Robot& simple,
                          const JointValues& given);

/// Warns of each, or with --strict refuses the first one.
void tellProblems(const UrdfBoundsOptions& options, const std::vector<std::string>& problems);

/// One value per joint of the robot in that row.
JointValues valuesOf(const JointTable& table, std::size_t row, JointValues given);

}  // namespace link_bounds

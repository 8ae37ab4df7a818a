// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What was measured, and how to find one's way in it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/common/row.h"

namespace link_bounds::bench {

/// One method on one mesh.
struct Result {
  std::string mesh;
  std::string kind;  ///< robot, model or synthetic
  std::size_t vertices;
  std::size_t hull;  ///< points that can be extreme
  std::string method;
  std::optional<bool> exact;  ///< none: the boxes were not compared with exact ones
  double volume_ratio;        ///< to the exact box, mean; not a number: not computed
  std::size_t bytes;          ///< what the boxes are computed from; 0 if not known
  double ns = 0;              ///< per box, median
};

using Results = std::vector<Result>;
using Filter = std::function<bool(const Result&)>;

/// For programs and tables.
Row rowOf(const Result& result);
Rows rowsOf(const Results& results);

bool isRobot(const Result& result);

/// Of an update of many links; `mesh` is links:COUNT:shared16 or links:COUNT:distinct.
bool isLinkCount(const Result& result);

/// Null if there is none.
const Result* find(const Results& results, const std::string& mesh, const std::string& method);

/// Not a number if there are no values.
double median(std::vector<double> values);

/// What this part of the values does not exceed; not a number if there are none.
double quantile(std::vector<double> values, double part);

/// ns of `method` / ns of `other` for each mesh that passes and has both.
std::vector<double> ratios(const Results& results, const std::string& method,
                           const std::string& other, const Filter& filter);

}  // namespace link_bounds::bench

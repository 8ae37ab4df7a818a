// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tables of boxes and of other volumes have in common.
#pragma once

#include <Eigen/Core>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tools/text/safe_text.h"

namespace link_bounds {

enum class Format { kTable, kCsv, kJson };

/// Names whose volume is missing or known not to cover everything, each with the reason.
using Reasons = std::vector<std::pair<std::string, std::string>>;

using Numbers = std::vector<double>;

/// The cells of a line for people: a name, then what the numbers are.
using Row = std::vector<std::string>;

/// Numbers rounded for people: to micrometres, and without a minus sign before a zero.
Row shortRow(const std::string& name, const Numbers& numbers);

/// Names to the left, numbers to the right; all rows must be as long as the first.
void writeAligned(const std::vector<Row>& rows, std::ostream& out);

/// For people; nothing if there are none.
void writeIncomplete(const Reasons& incomplete, std::ostream& out);

void writeCsvRow(const std::string& name, const Numbers& numbers, std::ostream& out);

/// An array.
std::string jsonNumbers(const Eigen::VectorXd& numbers);

/// One member per line.
template <class Value, class ToJson>
std::string jsonObject(const std::vector<std::pair<std::string, Value>>& members,
                       const ToJson& to_json) {
  std::string result;
  for (const auto& [name, value] : members) {
    result += (result.empty() ? "\n  " : ",\n  ") + jsonString(name) + ": " + to_json(value);
  }
  return "{" + result + "}";
}

}  // namespace link_bounds

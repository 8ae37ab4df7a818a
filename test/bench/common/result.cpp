// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Look-ups and medians.
#include "bench/common/result.h"

#include <algorithm>
#include <limits>

namespace link_bounds::bench {

Row rowOf(const Result& result) {
  return {{"mesh", result.mesh},
          {"kind", result.kind},
          {"vertices", result.vertices},
          {"hull", result.hull},
          {"method", result.method},
          {"exact", result.exact},
          {"ns", result.ns},
          {"volume_ratio", result.volume_ratio},
          {"bytes", result.bytes ? Value(result.bytes) : Value()}};
}

Rows rowsOf(const Results& results) {
  Rows rows;
  for (const Result& result : results)
    rows.push_back(rowOf(result));
  return rows;
}

bool isRobot(const Result& result) {
  return result.kind == "robot";
}

bool isLinkCount(const Result& result) {
  return result.mesh.rfind("links:", 0) == 0;
}

const Result* find(const Results& results, const std::string& mesh, const std::string& method) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const Result& result) {
    return result.mesh == mesh && result.method == method;
  });
  return found == results.end() ? nullptr : &*found;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

std::vector<double> ratios(const Results& results, const std::string& method,
                           const std::string& other, const Filter& filter) {
  std::vector<double> values;
  for (const Result& result : results) {
    if (result.method != method || !filter(result)) continue;
    if (const Result* beside = find(results, result.mesh, other))
      values.push_back(result.ns / beside->ns);
  }
  return values;
}

}  // namespace link_bounds::bench

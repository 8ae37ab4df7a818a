// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians and means are over the robot meshes.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

#include "bench/common/table.h"
#include "bench/core/core_report.h"

namespace link_bounds::bench {
namespace {

constexpr int kMeshWidth = 39;

std::vector<std::string> methodsOf(const Results& results) {
  std::vector<std::string> methods;
  for (const Result& result : results) {
    if (std::find(methods.begin(), methods.end(), result.method) == methods.end())
      methods.push_back(result.method);
  }
  return methods;
}

std::vector<Column> columnsOf(std::vector<Column> columns, const Results& results) {
  for (const std::string& method : methodsOf(results))
    columns.push_back({method});
  return columns;
}

double medianOf(const Results& results, const std::string& method, double (*value)(const Result&)) {
  std::vector<double> values;
  for (const Result& result : results) {
    if (result.method == method && isRobot(result)) values.push_back(value(result));
  }
  return median(values);
}

double shareOfExact(const Results& results, const std::string& method) {
  double exact = 0, all = 0;
  for (const Result& result : results) {
    if (result.method != method || !isRobot(result)) continue;
    exact += *result.exact;
    ++all;
  }
  return exact / all;
}

template <class ValueOf>
Row rowOf(const Results& results, const char* what, const ValueOf& value_of) {
  Row row{{"of all", what}};
  for (const std::string& method : methodsOf(results))
    row.emplace_back(method, value_of(method));
  return row;
}

Rows medians(const Results& results, const std::string& ours) {
  const auto of = [&results](double (*value)(const Result&)) {
    return
        [&results, value](const std::string& method) { return medianOf(results, method, value); };
  };
  return {rowOf(results, "ns", of([](const Result& result) { return result.ns; })),
          rowOf(results, "times ours",
                [&](const std::string& method) {
                  return median(ratios(results, method, ours, isRobot));
                }),
          rowOf(results, "volume / exact volume",
                of([](const Result& result) { return result.volume_ratio; })),
          rowOf(results, "share of meshes with exact boxes",
                [&](const std::string& method) { return shareOfExact(results, method); }),
          rowOf(results, "kB a box is computed from", of([](const Result& result) {
                  return result.bytes ? static_cast<double>(result.bytes) / 1e3 : std::nan("");
                }))};
}

void printLinkCounts(const Results& results, const std::string& ours) {
  const Table table(
      "Updates of many links, all turning at random, by " + ours,
      {{"mesh", "links", kMeshWidth}, {"ns", "ns per link"}, {"MB of tables"}, {"exact"}});
  for (const Result& result : results) {
    Row row = rowOf(result);
    row.emplace_back("MB of tables", static_cast<double>(result.bytes) / 1e6);
    table.add(row);
  }
}

}  // namespace

void printCoreTables(const Results& results, const std::string& ours) {
  Results meshes(results), links;
  const auto end = std::stable_partition(meshes.begin(), meshes.end(),
                                         [](const auto& each) { return !isLinkCount(each); });
  links.assign(end, meshes.end());
  meshes.erase(end, meshes.end());
  printTable("ns per box", columnsOf({{"mesh", "", kMeshWidth}, {"vertices"}, {"hull"}}, meshes),
             pivot(rowsOf(meshes), {"mesh", "vertices", "hull"}, "method", "ns"));
  printTable("Medians over the robot meshes", columnsOf({{"of all", " ", kMeshWidth}}, meshes),
             medians(meshes, ours));
  std::cout
      << "\nExact: to 1e-9 of the longest side, which the single precision of Bullet misses.\n";
  printLinkCounts(links, ours);
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians and means are over the robot meshes.
#include <algorithm>
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

Rows medians(const Results& results, const std::string& ours) {
  const Rows rows = rowsOf(results);
  Row ns{{"of all", "ns"}}, times{{"of all", "times ours"}};
  Row volume{{"of all", "volume / exact volume"}};
  Row exact{{"of all", "share of meshes with exact boxes"}};
  Row kilobytes{{"of all", "kB a box is computed from"}};
  for (const std::string& method : methodsOf(results)) {
    const auto numbers = [&](const char* name) {
      return numbersOf(rows, {{"method", method}, {"kind", "robot"}}, name);
    };
    const std::vector<double> truths = numbers("exact");
    const double count = std::accumulate(truths.begin(), truths.end(), 0.0);
    ns.emplace_back(method, median(numbers("ns")));
    times.emplace_back(method, median(ratios(results, method, ours, isRobot)));
    volume.emplace_back(method, median(numbers("volume_ratio")));
    exact.emplace_back(method, count / static_cast<double>(truths.size()));
    kilobytes.emplace_back(method, median(numbers("bytes")) / 1e3);
  }
  return {ns, times, volume, exact, kilobytes};
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

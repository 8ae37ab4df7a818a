// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times distances of robots' links, ours and others: distances_bench [--quick] [--json FILE]
#include <iostream>

#include "bench/common/benchmark_main.h"
#include "bench/common/machine.h"
#include "bench/distances/distance_report.h"

namespace link_bounds::bench {
namespace {

/// A peer that is not installed is not compiled.
std::vector<DistanceSetting> distanceSettings() {
  std::vector<DistanceSetting> settings;
  addOurDistances(settings);
#ifdef LINK_BOUNDS_WITH_FCL
  addFclDistances(settings);
#else
  std::cout << "left out, because this system lacks it: fcl\n";
#endif
#ifdef LINK_BOUNDS_WITH_BULLET
  addBulletDistances(settings);
#else
  std::cout << "left out, because this system lacks it: bullet\n";
#endif
  return settings;
}

void printHead() {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << "\npeers: " << LINK_BOUNDS_PEERS
            << "\n\nnear: pairs within 0.1 m. all: every pair that no joint connects, without a "
               "limit.\nupdate: all pairs of a pose together, with a limit of 0.1 m.\n"
               "random: each pose is new. coherent: joints move by at most 0.01 rad.\n"
               "at rest: no link moves. on a base: all links move together.\n"
               "us: median, and what 9 of 10 do not exceed\n\n"
            << std::flush;
}

/// Of the trees of all links, each counted once; none without triangles.
std::optional<double> bytesPerTriangle(const DistanceRobot& robot) {
  std::map<std::shared_ptr<const TriangleTree>, double> trees;
  for (const DistanceLink& link : robot.links) {
    for (const BodyShape& shape : link.body.shapes) {
      if (shape.triangles) trees[shape.triangles] = static_cast<double>(bytes(*shape.triangles));
    }
  }
  double sum = 0;
  for (const auto& tree : trees)
    sum += tree.second;
  if (robot.triangles == 0) return std::nullopt;
  return sum / static_cast<double>(robot.triangles);
}

void benchmarkDistances(bool quick, std::ostream* json) {
  printHead();
  const std::vector<DistanceSetting> settings = distanceSettings();
  DistanceRows rows;
  std::vector<double> bytes_per_triangle;
  const auto add = [&rows](const DistanceRows& more) {
    for (const DistanceRow& row : more) {
      print(row, std::cout);
      rows.push_back(row);
    }
  };
  for (const DistanceRobot& robot :
       distanceRobots(LINK_BOUNDS_DEMO_URDF, quick ? 5 : 50, std::cout)) {
    add(measurePairs(robot, settings));
    add(measureUpdates(robot));
    if (const auto bytes = bytesPerTriangle(robot)) bytes_per_triangle.push_back(*bytes);
  }
  add(measureGrowth(settings, quick));
  printDistanceTargets(rows, bytes_per_triangle, std::cout);
  if (json) writeDistanceJson(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkDistances);
}

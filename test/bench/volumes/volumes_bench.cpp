// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How tight volumes are and what they cost: volumes_bench [--quick] [--json FILE]
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "bench/common/benchmark_main.h"
#include "bench/common/json.h"
#include "bench/common/machine.h"
#include "bench/volumes/volumes_measure.h"

namespace link_bounds::bench {
namespace {

using Value = double Result::*;

/// The mean of a column over the links of all robots, or of one.
double mean(const Results& results, const std::string& method, Value value,
            const std::string& robot = "") {
  double sum = 0;
  double links = 0;
  for (const Result& result : results) {
    const bool is_meant = result.method == method && (robot.empty() || result.mesh == robot);
    if (!is_meant || std::isnan(result.*value)) continue;
    sum += result.*value * static_cast<double>(result.vertices);
    links += static_cast<double>(result.vertices);
  }
  return sum / links;
}

std::string toText(double value) {
  if (std::isnan(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

void printRobot(const Results& results, const MeasuredRobot& robot, std::ostream& out) {
  out << "| " << robot.name << " | " << robot.links.size();
  for (const char* method : {kAabb, kAabbAtJoints, kSphere, kOrientedBox})
    out << " | " << toText(mean(results, method, &Result::volume_ratio, robot.name));
  out << " |\n";
}

void printCosts(const Results& results, const char* name, const char* method, const char* once,
                const char* overlap, std::ostream& out) {
  out << "| " << name << " | " << toText(mean(results, method, &Result::volume_ratio)) << " | "
      << toText(mean(results, method, &Result::ns)) << " | "
      << toText(mean(results, once, &Result::ns) / 1e6) << " | "
      << toText(mean(results, overlap, &Result::ns)) << " |\n";
}

void print(const Results& results, const std::vector<MeasuredRobot>& robots, std::ostream& out) {
  out << "Mean volume, divided by that of the axis-aligned box of the same link turned at "
         "random\n\n"
         "| robot | links | box, turned at random | box, joints at random | sphere | oriented box "
         "|\n|---|---|---|---|---|---|\n";
  for (const MeasuredRobot& robot : robots)
    printRobot(results, robot, out);
  out << "\nMeans over all links; -: not measured\n\n"
         "| bounded by | volume | ns per update | ms once, beside the table | ns per overlap test "
         "|\n|---|---|---|---|---|\n";
  printCosts(results, "axis-aligned box", kAabb, "", kOverlapAabb, out);
  printCosts(results, "axis-aligned box, joints at random", kAabbAtJoints, "", "", out);
  printCosts(results, "sphere", kSphere, kPrepareSphere, kOverlapSphere, out);
  printCosts(results, "oriented box", kOrientedBox, kPrepareOrientedBox, "", out);
}

void benchmarkVolumes(bool quick, std::ostream* json) {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName() << "\n";
  const auto robots = chooseRobots(LINK_BOUNDS_DEMO_URDF, std::cout);
  const Results results = measureVolumes(robots, quick);
  std::cout << "\n";
  print(results, robots, std::cout);
  if (json) writeJson(results, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkVolumes);
}

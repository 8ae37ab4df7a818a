// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians over pairs and poses, and of these over robots.
#include "bench/distances/distance_report.h"

#include <algorithm>

#include "bench/common/result.h"
#include "bench/common/target.h"

namespace link_bounds::bench {
namespace {

std::vector<double> smallest(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {*std::min_element(values.begin(), values.end())};
}

/// The longest over the shortest time of any number of triangles, in each motion.
std::vector<double> growth(const Rows& rows) {
  std::vector<double> result;
  for (const char* const motion : {"coherent", "random"}) {
    const std::vector<double> times =
        numbersOf(rows, {{"which", "generated"}, {"method", "ours"}, {"motion", motion}}, "us");
    if (times.empty()) continue;
    const auto [least, most] = std::minmax_element(times.begin(), times.end());
    result.push_back(*most / *least);
  }
  return result;
}

}  // namespace

Row rowOf(const DistanceRow& row) {
  const bool is_update = row.which == "update", is_ours = row.method == "ours";
  const double pairs = is_update ? static_cast<double>(row.pairs) : 1;
  const double us = median(row.ns) / 1e3, p90_us = quantile(row.ns, 0.9) / 1e3;
  return {{"robot", row.robot},
          {"motion", row.motion},
          {"level", row.level},
          {"method", row.method},
          {"which", row.which},
          {"ns_per_pair", us * 1e3 / pairs},
          {"p90_ns_per_pair", p90_us * 1e3 / pairs},
          {"pairs", row.pairs},
          {"us", us},
          {"p90_us", p90_us},
          {"us_per_update", is_update ? Value(us) : Value()},
          {"times_ours", is_ours ? Value() : Value(median(row.ns) / median(row.ns_beside))},
          {"triangles", row.triangles ? Value(*row.triangles) : Value()}};
}

Table distanceTable() {
  return {
      "near: pairs within 0.1 m. all: every pair that no joint connects, without a limit.\n"
      "update: all pairs of a pose together, with a limit of 0.1 m.\n"
      "random: each pose is new. coherent: joints move by at most 0.01 rad.\n"
      "at rest: no link moves. on a base: all links move together.\n"
      "us: median, and what 9 of 10 do not exceed",
      {{"robot", "", 28},
       {"triangles"},
       {"motion", "", 9},
       {"which", "", 9},
       {"method", "", 13},
       {"level", "", 12},
       {"pairs"},
       {"us"},
       {"p90_us", "90 % us"},
       {"times_ours", "x ours"}}};
}

void printDistanceTargets(const Rows& rows, const std::vector<double>& bytes_per_triangle) {
  constexpr Wanted least = Wanted::kAtLeast;
  constexpr Wanted most = Wanted::kAtMost;
  const auto speedups = [&rows](const char* which) {
    return numbersOf(rows, {{"method", "fcl BVH"}, {"which", which}}, "times_ours");
  };
  const auto hull = [&rows](const char* motion) {
    const Row row{{"method", "ours"}, {"level", "hull"}, {"which", "near"}, {"motion", motion}};
    return numbersOf(rows, row, "us");
  };
  std::vector<Target> targets{
      {"fcl BVH / ours, mesh level, pairs within 0.1 m", least, 20, speedups("near")},
      {"fcl BVH / ours, mesh level, all pairs", least, 20, speedups("all")},
      {"fcl BVH / ours, mesh level, pairs within 0.1 m, worst row", least, 1,
       smallest(speedups("near"))},
      {"us per pair, hull level, random motion", most, 1.5, hull("random")},
      {"us per pair, hull level, coherent motion", most, 0.7, hull("coherent")}};
  const auto addUpdate = [&](const std::string& robot, const std::string& model, double moving,
                             double at_rest) {
    const std::string name = "us per update, mesh level, all pairs of the " + robot + ", " + model;
    const auto update = [&](const char* motion) {
      const Row row{{"which", "update"},
                    {"level", "mesh"},
                    {"robot", robot + " " + model},
                    {"motion", motion}};
      return numbersOf(rows, row, "us");
    };
    targets.push_back({name, most, moving, update("coherent")});
    targets.push_back({name + ", at rest", most, at_rest, update("at rest")});
  };
  addUpdate("panda", "collision", 40, 5);
  addUpdate("pr2", "collision", 300, 20);
  addUpdate("panda", "visual", 100, 5);
  addUpdate("pr2", "visual", 1000, 20);
  targets.push_back({"us per pair, hull level, longest / shortest of 1,000 to 200,000 triangles",
                     most, 1.5, growth(rows)});
  targets.push_back({"bytes per triangle of the trees", most, 64, bytes_per_triangle});
  printTargets(", by medians over the robots and their motions unless said", targets);
}

}  // namespace link_bounds::bench

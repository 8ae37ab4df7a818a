// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians over pairs and poses, and of these over robots.
#include "bench/distances/distance_report.h"

#include <algorithm>

#include "bench/common/result.h"
#include "bench/common/target.h"

namespace link_bounds::bench {
namespace {

double share(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

template <class Chosen, class Value>
std::vector<double> valuesOf(const DistanceRows& rows, const Chosen& is_chosen,
                             const Value& value) {
  std::vector<double> result;
  for (const DistanceRow& row : rows) {
    if (is_chosen(row)) result.push_back(value(row));
  }
  return result;
}

std::vector<double> smallest(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {*std::min_element(values.begin(), values.end())};
}

/// How many times the median of a peer's times is that of ours, for the same pairs.
std::vector<double> speedups(const DistanceRows& rows, const std::string& which) {
  return valuesOf(
      rows, [&](const DistanceRow& row) { return row.method == "fcl BVH" && row.which == which; },
      [](const DistanceRow& row) { return median(row.ns) / median(row.ns_beside); });
}

std::vector<double> hullMicroseconds(const DistanceRows& rows, const std::string& motion) {
  return valuesOf(
      rows,
      [&](const DistanceRow& row) {
        return row.method == "ours" && row.level == "hull" && row.which == "near" &&
               row.motion == motion;
      },
      [](const DistanceRow& row) { return median(row.ns) / 1e3; });
}

std::vector<double> updateMicroseconds(const DistanceRows& rows, const std::string& robot,
                                       const std::string& motion) {
  return valuesOf(
      rows,
      [&](const DistanceRow& row) {
        return row.which == "update" && row.level == "mesh" && row.motion == motion &&
               row.robot == robot;
      },
      [](const DistanceRow& row) { return median(row.ns) / 1e3; });
}

/// The longest over the shortest time of any number of triangles, in each motion.
std::vector<double> growth(const DistanceRows& rows) {
  std::vector<double> result;
  for (const char* const motion : {"coherent", "random"}) {
    const std::vector<double> times = valuesOf(
        rows,
        [&](const DistanceRow& row) {
          return row.which == "generated" && row.method == "ours" && row.motion == motion;
        },
        [](const DistanceRow& row) { return median(row.ns); });
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
  const double us = median(row.ns) / 1e3, p90_us = share(row.ns, 0.9) / 1e3;
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

void printDistanceTargets(const DistanceRows& rows, const std::vector<double>& bytes_per_triangle) {
  constexpr Wanted least = Wanted::kAtLeast;
  constexpr Wanted most = Wanted::kAtMost;
  std::vector<Target> targets{
      {"fcl BVH / ours, mesh level, pairs within 0.1 m", least, 20, speedups(rows, "near")},
      {"fcl BVH / ours, mesh level, all pairs", least, 20, speedups(rows, "all")},
      {"fcl BVH / ours, mesh level, pairs within 0.1 m, worst row", least, 1,
       smallest(speedups(rows, "near"))},
      {"us per pair, hull level, random motion", most, 1.5, hullMicroseconds(rows, "random")},
      {"us per pair, hull level, coherent motion", most, 0.7, hullMicroseconds(rows, "coherent")}};
  const auto addUpdate = [&](const std::string& robot, const std::string& model, double moving,
                             double at_rest) {
    const std::string name = "us per update, mesh level, all pairs of the " + robot + ", " + model;
    const std::string row = robot + " " + model;
    targets.push_back({name, most, moving, updateMicroseconds(rows, row, "coherent")});
    targets.push_back(
        {name + ", at rest", most, at_rest, updateMicroseconds(rows, row, "at rest")});
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

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians over pairs and poses, and of these over robots.
#include "bench/distances/distance_report.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

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

void print(const DistanceRow& row, std::ostream& out) {
  std::string name = row.robot;
  if (row.triangles) name += ", " + std::to_string(*row.triangles) + " triangles";
  out << std::left << std::setw(34) << name << std::setw(11) << row.motion << std::setw(10)
      << row.which << std::setw(14) << row.method << std::setw(13) << row.level << std::right
      << std::fixed << std::setprecision(2) << std::setw(6) << row.pairs << " pairs"
      << (row.which == "update" ? " together" : "         ") << std::setw(10)
      << median(row.ns) / 1e3 << std::setw(10) << share(row.ns, 0.9) / 1e3;
  if (row.method != "ours")
    out << std::setprecision(1) << std::setw(9) << median(row.ns) / median(row.ns_beside)
        << " x ours";
  out << "\n" << std::flush;
}

void printDistanceTargets(const DistanceRows& rows, const std::vector<double>& bytes_per_triangle,
                          std::ostream& out) {
  constexpr Wanted least = Wanted::kAtLeast;
  constexpr Wanted most = Wanted::kAtMost;
  out << "\nTargets, by medians over the robots and their motions unless said\n"
      << std::fixed << std::setprecision(2);
  const auto show = [&out](const Target& target) { print(target, "row", "rows", out); };
  show({"fcl BVH / ours, mesh level, pairs within 0.1 m", least, 20, speedups(rows, "near")});
  show({"fcl BVH / ours, mesh level, all pairs", least, 20, speedups(rows, "all")});
  show({"fcl BVH / ours, mesh level, pairs within 0.1 m, worst row", least, 1,
        smallest(speedups(rows, "near"))});
  show({"us per pair, hull level, random motion", most, 1.5, hullMicroseconds(rows, "random")});
  show({"us per pair, hull level, coherent motion", most, 0.7, hullMicroseconds(rows, "coherent")});
  const auto showUpdate = [&](const std::string& robot, const std::string& model, double moving,
                              double at_rest) {
    const std::string name = "us per update, mesh level, all pairs of the " + robot + ", " + model;
    const std::string row = robot + " " + model;
    show({name, most, moving, updateMicroseconds(rows, row, "coherent")});
    show({name + ", at rest", most, at_rest, updateMicroseconds(rows, row, "at rest")});
  };
  showUpdate("panda", "collision", 40, 5);
  showUpdate("pr2", "collision", 300, 20);
  showUpdate("panda", "visual", 100, 5);
  showUpdate("pr2", "visual", 1000, 20);
  show({"us per pair, hull level, longest / shortest of 1,000 to 200,000 triangles", most, 1.5,
        growth(rows)});
  show({"bytes per triangle of the trees", most, 64, bytes_per_triangle});
}

void writeDistanceJson(const DistanceRows& rows, std::ostream& out) {
  const char* separator = "[\n";
  for (const DistanceRow& row : rows) {
    const bool is_update = row.which == "update";
    const double pairs = is_update ? static_cast<double>(row.pairs) : 1;
    out << separator << "{\"robot\": " << std::quoted(row.robot)
        << ", \"motion\": " << std::quoted(row.motion) << ", \"level\": " << std::quoted(row.level)
        << ", \"method\": " << std::quoted(row.method) << ", \"which\": " << std::quoted(row.which)
        << ", \"ns_per_pair\": " << std::to_string(median(row.ns) / pairs)
        << ", \"p90_ns_per_pair\": " << std::to_string(share(row.ns, 0.9) / pairs)
        << ", \"pairs\": " << row.pairs;
    if (is_update) out << ", \"us_per_update\": " << std::to_string(median(row.ns) / 1e3);
    if (row.method != "ours")
      out << ", \"times_ours\": " << std::to_string(median(row.ns) / median(row.ns_beside));
    if (row.triangles) out << ", \"triangles\": " << *row.triangles;
    out << "}";
    separator = ",\n";
  }
  out << "\n]\n";
}

}  // namespace link_bounds::bench

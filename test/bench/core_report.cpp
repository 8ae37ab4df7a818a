// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A table with one row per method, medians over the robot's meshes first.
#include "core_report.h"

#include <algorithm>
#include <functional>
#include <iomanip>
#include <map>
#include <ostream>

namespace link_bounds::bench {
namespace {

using Filter = std::function<bool(const Case&)>;

const Case* find(const std::vector<Case>& rows, const std::string& mesh,
                 const std::string& method) {
  for (const Case& row : rows) {
    if (row.mesh == mesh && row.method == method) return &row;
  }
  return nullptr;
}

/// The first whose name ends so.
const Case* findEnding(const std::vector<Case>& rows, const std::string& end,
                       const std::string& method) {
  for (const Case& row : rows) {
    if (row.method != method || row.mesh.size() < end.size()) continue;
    if (row.mesh.compare(row.mesh.size() - end.size(), end.size(), end) == 0) return &row;
  }
  return nullptr;
}

/// The median over meshes of the ratio between the medians of two methods; 0 without any.
double medianRatio(const std::vector<Case>& rows, const std::string& a, const std::string& b,
                   const Filter& filter) {
  std::vector<double> ratios;
  for (const Case& row : rows) {
    if (row.method != a || !filter(row)) continue;
    if (const Case* other = find(rows, row.mesh, b)) {
      ratios.push_back(median(row.ns) / median(other->ns));
    }
  }
  return ratios.empty() ? 0 : median(ratios);
}

bool isRobot(const Case& row) {
  return row.kind == "robot";
}

void printTarget(std::ostream& out, const std::string& text, double value, double limit,
                 bool at_least) {
  if (value == 0) return;
  const bool reached = at_least ? value >= limit : value <= limit;
  out << "  " << (reached ? "reached" : "MISSED ") << "  " << std::left << std::setw(66) << text
      << std::right << std::setw(10) << value << (at_least ? "  >= " : "  <= ") << limit << "\n";
}

std::vector<std::string> methodsOf(const std::vector<Case>& rows) {
  std::vector<std::string> methods;
  for (const Case& row : rows) {
    if (std::find(methods.begin(), methods.end(), row.method) == methods.end())
      methods.push_back(row.method);
  }
  return methods;
}

void printMedians(const std::vector<Case>& rows, std::ostream& out) {
  out << "\nMedians over the robots' meshes\n"
      << "  method                  ns  volume/exact   times corners8\n";
  for (const std::string& method : methodsOf(rows)) {
    std::vector<double> ns, volumes;
    for (const Case& row : rows) {
      if (row.method != method || !isRobot(row)) continue;
      ns.push_back(median(row.ns));
      volumes.push_back(row.volume_ratio);
    }
    if (ns.empty()) continue;
    out << "  " << std::left << std::setw(16) << method << std::right << std::setw(10) << median(ns)
        << std::setw(14) << median(volumes) << std::setw(17)
        << medianRatio(rows, method, "corners8", isRobot) << "\n";
  }
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void printTable(const std::vector<Case>& rows, std::ostream& out) {
  out << std::fixed << std::setprecision(1);
  out << "mesh                                              vertices   hull  method"
         "                    ns  volume/exact  bytes\n";
  for (const Case& row : rows) {
    const std::string name =
        row.mesh.size() > 48 ? row.mesh.substr(row.mesh.size() - 48) : row.mesh;
    out << std::left << std::setw(48) << name << std::right << std::setw(10) << row.vertices
        << std::setw(7) << row.hull << "  " << std::left << std::setw(16) << row.method
        << std::right << std::setw(12) << median(row.ns) << std::setprecision(2) << std::setw(10)
        << row.volume_ratio << (row.exact ? " exact" : "      ") << std::setprecision(1)
        << std::setw(9) << row.bytes << "\n";
  }
  out << std::setprecision(2);
  printMedians(rows, out);
}

void printTargets(const std::vector<Case>& rows, std::ostream& out) {
  const std::string ours = find(rows, rows.front().mesh, "ours_avx2") ? "ours_avx2" : "ours_sse2";
  const auto large = [](const Case& row) { return isRobot(row) && row.vertices >= 10000; };
  const auto hull = [](const Case& row) { return isRobot(row) && row.hull >= 300; };
  out << "\nTargets, by " << ours << " unless said\n" << std::setprecision(2);
  const auto ratio = [&](const char* a, const std::string& b, const Filter& filter) {
    return medianRatio(rows, a, b, filter);
  };
  printTarget(out, "faster than paper_loop, from 10,000 vertices on",
              ratio("paper_loop", ours, large), 2000, true);
  printTarget(out, "faster than bullet_slow, hulls from 300 on", ratio("bullet_slow", ours, hull),
              25, true);
  printTarget(out, "faster than fcl_exact, hulls from 300 on", ratio("fcl_exact", ours, hull), 25,
              true);
  printTarget(out, "of geometric_shapes", medianRatio(rows, ours, "geometric_shapes", isRobot),
              0.15, false);
  printTarget(out, "times corners8, SSE2", ratio("ours_sse2", "corners8", isRobot), 3.0, false);
  printTarget(out, "times corners8, AVX2", ratio("ours_avx2", "corners8", isRobot), 2.5, false);
  printTarget(out, "times eigen, linear part unchanged", ratio("ours_unchanged", "eigen", isRobot),
              2.0, false);
  const Case* dragon = findEnding(rows, "dragon_vrip_res2.ply", ours);
  const Case* base = findEnding(rows, "ur5e/visual/base.dae", ours);
  if (dragon && base) {
    printTarget(out, "times ur5e's base for the dragon of 100,000 vertices",
                median(dragon->ns) / median(base->ns), 1.3, false);
  }
  printTarget(out, "times the cost per link of 50 for 1,000 links sharing 16 meshes",
              median(find(rows, "links:1000:shared16", "ours")->ns) /
                  median(find(rows, "links:50:shared16", "ours")->ns),
              1.6, false);
}

void writeJson(const std::vector<Case>& rows, std::ostream& out) {
  out << std::setprecision(6) << std::defaultfloat << "[";
  const char* separator = "\n";
  for (const Case& row : rows) {
    out << separator << R"({"mesh": ")" << row.mesh << R"(", "kind": ")" << row.kind
        << R"(", "vertices": )" << row.vertices << R"(, "hull": )" << row.hull << R"(, "method": ")"
        << row.method << R"(", "exact": )" << (row.exact ? "true" : "false") << R"(, "ns": )"
        << median(row.ns) << R"(, "volume_ratio": )" << row.volume_ratio << R"(, "bytes": )"
        << row.bytes << "}";
    separator = ",\n";
  }
  out << "\n]\n";
}

}  // namespace link_bounds::bench

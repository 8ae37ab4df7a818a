// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians of ratios within rounds, because the speed of the machine changes between rounds.
#include "bench/overlaps/overlap_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <set>

#include "bench/common/result.h"
#include "bench/common/target.h"

namespace link_bounds::bench {
namespace {

const char* const kOurs = "ours";
constexpr double kMaxMedian = 1;
constexpr double kMaxOfAnyScene = 2;

bool isSameScene(const OverlapResult& a, const OverlapResult& b) {
  return a.scene == b.scene && a.boxes == b.boxes;
}

double ratio(const OverlapResult& ours, const OverlapResult& peer) {
  std::vector<double> values;
  for (std::size_t i = 0; i < ours.us_per_round.size(); ++i)
    values.push_back(ours.us_per_round[i] / peer.us_per_round[i]);
  return median(values);
}

/// Our time divided by that of the faster peer; NaN without peers.
double ratioToFaster(const OverlapResult& ours, const OverlapResults& results) {
  double largest = std::nan("");
  for (const OverlapResult& peer : results) {
    if (peer.method != kOurs && isSameScene(ours, peer))
      largest = std::fmax(largest, ratio(ours, peer));
  }
  return largest;
}

}  // namespace

void printOverlaps(const OverlapResults& results, std::ostream& out) {
  out << "us per step, medians\n" << std::fixed;
  for (const OverlapResult& result : results) {
    out << std::left << std::setw(20) << result.scene << std::right << std::setw(6) << result.boxes
        << " boxes" << std::setw(6) << result.pairs << " pairs  " << std::left << std::setw(7)
        << result.method << std::right << std::setprecision(1) << std::setw(9)
        << median(result.us_per_round);
    if (result.method == kOurs) {
      out << std::setprecision(2) << "  " << ratioToFaster(result, results)
          << " of the faster peer's\n";
    } else {
      out << "  " << result.setting << "\n";
    }
  }
}

void printOverlapTargets(const OverlapResults& results, std::ostream& out) {
  out << "\nTargets for ours / the faster peer\n" << std::fixed << std::setprecision(2);
  std::set<std::size_t> sizes;
  for (const OverlapResult& result : results)
    sizes.insert(result.boxes);
  for (const std::size_t size : sizes) {
    std::vector<double> values;
    for (const OverlapResult& result : results) {
      const bool is_meant = result.method == kOurs && result.boxes == size;
      const double value = is_meant ? ratioToFaster(result, results) : std::nan("");
      if (!std::isnan(value)) values.push_back(value);
    }
    const std::string text = "overlaps / faster peer, " + std::to_string(size) + " boxes";
    std::sort(values.begin(), values.end());
    std::vector<double> slowest(values);
    if (!values.empty()) slowest.assign(1, values.back());
    print({text, Wanted::kAtMost, kMaxMedian, values}, "scene", "scenes", out);
    print({text + ", slowest scene", Wanted::kAtMost, kMaxOfAnyScene, slowest}, "scene", "scenes",
          out);
  }
}

void writeOverlapJson(const OverlapResults& results, std::ostream& out) {
  const char* separator = "[\n";
  for (const OverlapResult& result : results) {
    out << separator << "{\"method\": " << std::quoted(result.method)
        << ", \"scene\": " << std::quoted(result.scene) << ", \"boxes\": " << result.boxes
        << ", \"us_per_step\": " << std::to_string(median(result.us_per_round))
        << ", \"pairs\": " << result.pairs << "}";
    separator = ",\n";
  }
  out << "\n]\n";
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Medians of ratios within rounds, because the speed of the machine changes between rounds.
#include "overlap_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <set>

#include "result.h"

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

void printTarget(const std::string& text, double limit, double value, std::ostream& out) {
  out << std::left << std::setw(60) << text << " <= " << limit << ": ";
  if (std::isnan(value)) {
    out << "not measured\n";
  } else {
    out << value << (value <= limit ? "  reached\n" : "  MISSED\n");
  }
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
      if (result.method == kOurs && result.boxes == size)
        values.push_back(ratioToFaster(result, results));
    }
    const std::string boxes = std::to_string(size) + " boxes";
    printTarget("median of the scenes, " + boxes, kMaxMedian, median(values), out);
    printTarget("the slowest scene, " + boxes, kMaxOfAnyScene,
                *std::max_element(values.begin(), values.end()), out);
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

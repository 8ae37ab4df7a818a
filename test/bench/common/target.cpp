// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Columns that suit texts of up to 76 characters. scripts/figures reads these lines.
#include "bench/common/target.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "bench/common/result.h"

namespace link_bounds::bench {
namespace {

void print(const Target& target) {
  const bool wants_more = target.wanted == Wanted::kAtLeast;
  std::cout << std::left << std::setw(76) << target.text << std::right
            << (wants_more ? " >= " : " <= ") << std::setw(7) << target.limit << ": ";
  if (target.values.empty()) {
    std::cout << "not measured\n";
    return;
  }
  const auto [smallest, largest] = std::minmax_element(target.values.begin(), target.values.end());
  const double value = median(target.values);
  const bool is_reached = wants_more ? value >= target.limit : value <= target.limit;
  std::cout << std::setw(9) << value << (is_reached ? "  reached" : "  MISSED ") << " (from "
            << *smallest << " to " << *largest << " on " << target.values.size()
            << (target.values.size() == 1 ? " value)\n" : " values)\n");
}

}  // namespace

void printTargets(const std::string& what, const std::vector<Target>& targets) {
  std::cout << "\nTargets" << what << "\n" << std::fixed << std::setprecision(2);
  for (const Target& target : targets)
    print(target);
}

}  // namespace link_bounds::bench

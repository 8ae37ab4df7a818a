// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Columns that suit texts of up to 76 characters.
#include "bench/common/target.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include "bench/common/result.h"

namespace link_bounds::bench {

void print(const Target& target, const std::string& one, const std::string& many,
           std::ostream& out) {
  const bool wants_more = target.wanted == Wanted::kAtLeast;
  out << std::left << std::setw(76) << target.text << std::right << (wants_more ? " >= " : " <= ")
      << std::setw(7) << target.limit << ": ";
  if (target.ratios.empty()) {
    out << "not measured\n";
    return;
  }
  const auto [smallest, largest] = std::minmax_element(target.ratios.begin(), target.ratios.end());
  const double value = median(target.ratios);
  const double gain = wants_more ? value / target.limit : target.limit / value;
  out << std::setw(9) << value << (gain >= 1 ? "  reached" : "  MISSED ") << " (from " << *smallest
      << " to " << *largest << " on " << target.ratios.size() << " "
      << (target.ratios.size() == 1 ? one : many) << ")\n";
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A class is found from the exponent and the first bits of the fraction.
#include "node/diagnostics/duration_histogram.h"

#include <algorithm>
#include <cmath>

namespace link_bounds {
namespace {

constexpr double kShortest = 1e-3;  // ms

}  // namespace

void DurationHistogram::add(double milliseconds) {
  int exponent = 0;
  const double fraction = std::frexp(std::max(milliseconds / kShortest, 1.0), &exponent);
  const int step = static_cast<int>((fraction - 0.5) * 2 * kPerOctave);
  const int last = static_cast<int>(counts_.size()) - 1;
  ++counts_[static_cast<std::size_t>(std::min((exponent - 1) * kPerOctave + step, last))];
  ++count_;
  longest_ = std::max(longest_, milliseconds);
}

double DurationHistogram::quantile(double part) const {
  const double wanted = part * static_cast<double>(count_);
  std::uint64_t sum = 0;
  for (int i = 0; i < kOctaves * kPerOctave - 1; ++i) {
    sum += counts_[static_cast<std::size_t>(i)];
    if (static_cast<double>(sum) < wanted) continue;
    const double fraction = 1 + static_cast<double>(i % kPerOctave + 1) / kPerOctave;
    return std::min(longest_, kShortest * std::ldexp(fraction, i / kPerOctave));
  }
  return longest_;
}

}  // namespace link_bounds

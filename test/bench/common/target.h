// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A promise: a limit for the median of some ratios.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace link_bounds::bench {

enum class Wanted { kAtLeast, kAtMost };

struct Target {
  std::string text;
  Wanted wanted;
  double limit;
  std::vector<double> ratios;
};

/// One line: the limit, the median, whether it is reached, and the range. There is a ratio for each
/// `one`, such as "mesh"; `many` is its plural.
void print(const Target& target, const std::string& one, const std::string& many,
           std::ostream& out);

}  // namespace link_bounds::bench

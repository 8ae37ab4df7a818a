// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A promise: a limit for the median of some values.
#pragma once

#include <string>
#include <vector>

namespace link_bounds::bench {

enum class Wanted { kAtLeast, kAtMost };

struct Target {
  std::string text;
  Wanted wanted;
  double limit;
  std::vector<double> values;
};

/// A head, and one line for each to standard output: the limit, the median, whether it is reached,
/// and the range.
void printTargets(const std::string& what, const std::vector<Target>& targets);

}  // namespace link_bounds::bench

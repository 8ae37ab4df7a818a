// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What each program of scripts/bench bag prints of a bag that it has read.
#pragma once

#include <cstdint>
#include <iostream>

namespace link_bounds::bench {

struct BagCounts {
  std::uint64_t messages = 0;
  std::uint64_t transforms = 0;
  double sum = 0;  ///< of all translations along x, so that nothing is left out
};

inline void print(const BagCounts& counts) {
  std::cout.precision(17);
  std::cout << counts.messages << ' ' << counts.transforms << ' ' << counts.sum << '\n';
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the command lines of the benchmarks have in common.
#pragma once

#include <string>

namespace link_bounds::bench {

struct Options {
  bool quick = false;
  std::string json;  ///< file for the rows; "" = none
};

/// Throws std::runtime_error.
Options parse(int argc, char** argv);

}  // namespace link_bounds::bench

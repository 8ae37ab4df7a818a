// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line that all benchmarks understand: [--quick] [--json FILE]
#pragma once

#include <string>

namespace link_bounds::bench {

struct Options {
  bool quick = false;
  std::string json;  ///< "" = none
};

/// Throws std::runtime_error.
Options parseOptions(int argc, char** argv);

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is not known is an error.
#include "options.h"

#include <stdexcept>

namespace link_bounds::bench {

Options parseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      options.quick = true;
    } else if (argument == "--json" && i + 1 < argc) {
      options.json = argv[++i];
    } else {
      throw std::runtime_error("unknown argument or no value for it: " + argument);
    }
  }
  return options;
}

}  // namespace link_bounds::bench

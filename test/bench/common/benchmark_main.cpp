// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is not known is an error; so is a file that cannot be written, before the first measurement.
#include "bench/common/benchmark_main.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "bench/common/machine.h"

namespace link_bounds::bench {
namespace {

Options parseOptions(int argc, char** argv, bool has_cold) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      options.quick = true;
    } else if (argument == "--cold" && has_cold) {
      options.cold = true;
    } else if (argument == "--json" && i + 1 < argc) {
      options.json = argv[++i];
    } else {
      throw std::runtime_error("unknown argument or no value for it: " + argument);
    }
  }
  return options;
}

void run(const Options& options, const Benchmark& benchmark) {
  std::ofstream json;
  if (!options.json.empty()) json.open(options.json);
  if (!json) throw std::runtime_error("cannot write " + options.json);
  pinToOneCpu();
  benchmark(options.quick, json.is_open() ? &json : nullptr);
  if (!json.flush()) throw std::runtime_error("cannot write " + options.json);
}

}  // namespace

int runBenchmark(int argc, char** argv, const Benchmark& benchmark, const Benchmark& cold) try {
  const Options options = parseOptions(argc, argv, static_cast<bool>(cold));
  run(options, options.cold ? cold : benchmark);
  return 0;
} catch (const std::exception& error) {
  std::cerr << std::filesystem::path(argv[0]).filename().string() << ": " << error.what() << "\n";
  return 1;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is not known is an error; so is a file that cannot be written, before the first measurement.
#include "bench/common/driver.h"

#include <sched.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace link_bounds::bench {
namespace {

std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// On the last one we may use, since interrupts tend to the first.
void pinToOneCpu() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0)
    throw std::runtime_error("cannot find out which processors may be used");
  int last = CPU_SETSIZE - 1;
  while (!CPU_ISSET(last, &allowed))
    --last;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(last, &one);
  if (sched_setaffinity(0, sizeof(one), &one) != 0)
    throw std::runtime_error("cannot stay on one processor");
}

/// scripts/figures reads it.
void printMachine() {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << "\npeers: " << LINK_BOUNDS_PEERS << "\n"
            << std::flush;
}

struct Options {
  Measure measure;
  bool quick = false;
  std::string json = {};  ///< "" = none
};

const Benchmark& named(const std::string& name, const std::vector<Benchmark>& benchmarks) {
  const auto found =
      std::find_if(benchmarks.begin(), benchmarks.end(),
                   [&](const Benchmark& benchmark) { return benchmark.name == name; });
  if (found == benchmarks.end()) throw std::runtime_error("no benchmark is called " + name);
  return *found;
}

Options parseOptions(const std::vector<std::string>& words, const Benchmark& benchmark) {
  Options options{benchmark.measure};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--quick") {
      options.quick = true;
    } else if (words[i] == "--cold" && benchmark.cold) {
      options.measure = benchmark.cold;
    } else if (words[i] == "--json" && i + 1 < words.size()) {
      options.json = words[++i];
    } else {
      throw std::runtime_error("unknown argument or no value for it: " + words[i]);
    }
  }
  return options;
}

void run(const Options& options) {
  std::ofstream json;
  if (!options.json.empty()) json.open(options.json);
  if (!json) throw std::runtime_error("cannot write " + options.json);
  pinToOneCpu();
  printMachine();
  const Rows rows = options.measure(options.quick);
  if (!options.json.empty()) writeJson(rows, json);
  if (!json.flush()) throw std::runtime_error("cannot write " + options.json);
}

void printUsage(const std::vector<Benchmark>& benchmarks) {
  std::cout << "usage: bench NAME [--cold] [--quick] [--json FILE]\nNAME is one of:";
  for (const Benchmark& benchmark : benchmarks)
    std::cout << " " << benchmark.name << (benchmark.cold ? " (--cold)" : "");
  std::cout << "\nscripts/bench --help says what they measure.\n";
}

}  // namespace

int driveBenchmarks(int argc, char** argv, const std::vector<Benchmark>& benchmarks) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (std::find(words.begin(), words.end(), "--help") != words.end()) {
    printUsage(benchmarks);
    return 0;
  }
  if (words.empty()) throw std::runtime_error("no benchmark is named; see --help");
  run(parseOptions({words.begin() + 1, words.end()}, named(words.front(), benchmarks)));
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench: " << error.what() << "\n";
  return 1;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Linux tells and does it.
#include "bench/common/machine.h"

#include <sched.h>

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace link_bounds::bench {
namespace {

std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

/// The last one we may use, since interrupts tend to the first.
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

void printMachine() {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << "\npeers: " << LINK_BOUNDS_PEERS << "\n"
            << std::flush;
}

}  // namespace link_bounds::bench

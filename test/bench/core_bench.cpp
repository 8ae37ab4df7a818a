// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact boxes beside the peers' boxes: core_bench [--quick] [--json FILE]
#include <sched.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "core_report.h"
#include "core_suite.h"
#include "link_bounds/direction_table.h"

namespace link_bounds::bench {
namespace {

struct Options {
  bool quick = false;
  std::string json;
};

/// One processor for all, the last that we may use: the first ones serve interrupts.
void pin() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) return;
  for (int cpu = CPU_SETSIZE; cpu-- > 0;) {
    if (!CPU_ISSET(cpu, &allowed)) continue;
    CPU_ZERO(&allowed);
    CPU_SET(cpu, &allowed);
    sched_setaffinity(0, sizeof(allowed), &allowed);
    return;
  }
}

std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

const char* toText(QueryPath path) {
  switch (path) {
    case QueryPath::kPlain:
      return "plain";
    case QueryPath::kSse2:
      return "SSE2";
    case QueryPath::kAvx2:
      return "AVX2";
  }
  return "";
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      options.quick = true;
    } else if (argument == "--json" && i + 1 < argc) {
      options.json = argv[++i];
    } else {
      throw std::runtime_error("unknown argument: " + argument);
    }
  }
  return options;
}

void addAll(const std::vector<Mesh>& meshes) {
  for (const Mesh& mesh : meshes) {
    const Task turning = makeTask(mesh);
    addScans(turning);
    addOurs(turning, makeTask(mesh, false));
    addLooseRules(turning);
    addBullet(turning);
    addFcl(turning);
    addGeometricShapes(turning);
  }
  addLinkCounts(meshes);
}

void run(const Options& options) {
  const char* data = std::getenv("LINK_BOUNDS_DATA");
  const std::vector<Mesh> meshes = loadMeshes(data ? data : "", LINK_BOUNDS_DEMO, options.quick);
  std::cout << "flags: " << LINK_BOUNDS_FLAGS << "\nCPU: " << cpuName()
            << "\npath chosen: " << toText(queryPath()) << "\npeers: " << LINK_BOUNDS_PEERS
            << "\n\n"
            << std::flush;
  pin();
  addAll(meshes);
  runCases(options.quick ? 5 : 9, options.quick ? 0.004 : 0.01);
  printTable(cases(), std::cout);
  printTargets(cases(), std::cout);
  if (options.json.empty()) return;
  std::ofstream file(options.json);
  writeJson(cases(), file);
  if (!file.flush()) throw std::runtime_error("cannot write " + options.json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  link_bounds::bench::run(link_bounds::bench::parse(argc, argv));
} catch (const std::exception& error) {
  std::cerr << "core_bench: " << error.what() << "\n";
  return 1;
}

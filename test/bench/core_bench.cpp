// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of single meshes, ours and the peers': core_bench [--quick] [--json FILE]
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "json.h"
#include "machine.h"
#include "mesh_choice.h"
#include "methods.h"
#include "options.h"
#include "table.h"
#include "targets.h"

namespace link_bounds::bench {
namespace {

void printHead(std::ostream& out) {
  out << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
      << "\nquery path: " << nameOfOurs(queryPath()) << "\npeers: " << LINK_BOUNDS_PEERS << "\n";
}

void printLeftOut(const Suite& suite, std::ostream& out) {
  for (const char* method : kMethods) {
    const bool is_there = std::any_of(suite.begin(), suite.end(), [method](const Case& entry) {
      return entry.result.method == method;
    });
    if (!is_there) out << "left out, because this system or processor lacks it: " << method << "\n";
  }
}

Suite makeSuite(const MeasuredMeshes& meshes) {
  Suite suite;
  for (const MeasuredMesh& mesh : meshes)
    addMethods(Trial(mesh), suite);
  addLinkCounts(meshes, suite);
  return suite;
}

void benchmarkCore(const Options& options) {
  std::ofstream json;
  if (!options.json.empty()) json.open(options.json);
  if (!json) throw std::runtime_error("cannot write " + options.json);
  pinToOneCpu();
  printHead(std::cout);
  const char* data = std::getenv("LINK_BOUNDS_DATA");
  const MeasuredMeshes meshes =
      chooseMeshes(data ? data : "", LINK_BOUNDS_DEMO_MESHES, options.quick, std::cout);
  const std::string ours = nameOfOurs(queryPath());
  const Suite suite = makeSuite(meshes);
  printLeftOut(suite, std::cout);
  std::cout << "measuring " << suite.size() << " cases\n\n" << std::flush;
  const Results results = run(suite, options.quick ? 7 : 11, options.quick ? 0.005 : 0.01);
  printTable(results, ours, std::cout);
  printTargets(results, ours, std::cout);
  if (json.is_open()) writeJson(results, json);
  if (!json.flush()) throw std::runtime_error("cannot write " + options.json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  using namespace link_bounds::bench;
  benchmarkCore(parseOptions(argc, argv));
} catch (const std::exception& error) {
  std::cerr << "core_bench: " << error.what() << "\n";
  return 1;
}

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of single meshes, ours and the peers': core_bench [--cold] [--quick] [--json FILE]
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "bench/common/benchmark_main.h"
#include "bench/common/json.h"
#include "bench/common/machine.h"
#include "bench/common/mesh_choice.h"
#include "bench/core/cold_boxes.h"
#include "bench/core/methods.h"
#include "bench/core/table.h"
#include "bench/core/targets.h"

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

/// The time to build each mesh's table, once, for the rows of JSON.
void addBuilds(const MeasuredMeshes& meshes, Results& results) {
  for (const MeasuredMesh& mesh : meshes) {
    results.push_back({mesh.name, mesh.kind, mesh.mesh.vertices.size(), mesh.points->size(),
                       "build", std::nullopt, std::nan(""), mesh.points->bytes(), mesh.build_ns});
  }
}

void benchmarkCore(bool quick, std::ostream* json) {
  printHead(std::cout);
  const MeasuredMeshes meshes = chooseMeshes(LINK_BOUNDS_DEMO_MESHES, quick, std::cout);
  const std::string ours = nameOfOurs(queryPath());
  const Suite suite = makeSuite(meshes);
  printLeftOut(suite, std::cout);
  std::cout << "measuring " << suite.size() << " cases\n\n" << std::flush;
  Results results = run(suite, quick ? 7 : 11, quick ? 0.005 : 0.01);
  printTable(results, ours, std::cout);
  printTargets(results, ours, std::cout);
  addBuilds(meshes, results);
  if (json) writeJson(results, *json);
}

/// Ours beside two loose peers.
Suite makeColdSuite(const MeasuredMeshes& meshes, const std::string& ours) {
  Suite all;
  for (const MeasuredMesh& mesh : meshes) {
    const Trial trial(mesh);
    addOurs(trial, all);
    addLooseBoxes(trial, all);
#ifdef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
    addGeometricShapes(trial, all);
#endif
  }
  Suite suite;
  std::copy_if(all.begin(), all.end(), std::back_inserter(suite), [&ours](const Case& entry) {
    const std::string& method = entry.result.method;
    return method == ours || method == "corners8" || method == "geometric_shapes";
  });
  return suite;
}

void benchmarkCold(bool quick, std::ostream* json) {
  printHead(std::cout);
  const QueryPath path = queryPath();
  const Suite suite =
      makeColdSuite(chooseMeshes(LINK_BOUNDS_DEMO_MESHES, quick, std::cout), nameOfOurs(path));
  useQueryPath(path);
  std::cout << "measuring " << suite.size() << " cases\n\n" << std::flush;
  const Results results = runCold(suite, quick ? 15 : 25);
  printCold(results, nameOfOurs(path), std::cout);
  if (json) writeJson(results, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkCore,
                                          link_bounds::bench::benchmarkCold);
}

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of single meshes, ours and the peers'.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "bench/common/benchmarks.h"
#include "bench/common/mesh_choice.h"
#include "bench/core/cold_boxes.h"
#include "bench/core/core_report.h"
#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

/// Leaves out what this system or processor lacks.
void addMethods(const Trial& trial, Suite& suite) {
  addScans(trial, suite);
  addOurs(trial, suite);
  addLooseBoxes(trial, suite);
#ifdef LINK_BOUNDS_WITH_BULLET
  addBullet(trial, suite);
#endif
#ifdef LINK_BOUNDS_WITH_FCL
  addFcl(trial, suite);
#endif
#ifdef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
  addGeometricShapes(trial, suite);
#endif
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

}  // namespace

Rows benchmarkCore(bool quick) {
  const std::string ours = nameOfOurs(queryPath());
  std::cout << "query path: " << ours << "\n";
  const MeasuredMeshes meshes = chooseMeshes(quick);
  const Suite suite = makeSuite(meshes);
  std::cout << "measuring " << suite.size() << " cases\n" << std::flush;
  Results results = run(suite, quick ? 7 : 11, quick ? 0.005 : 0.01);
  printCoreTables(results, ours);
  printCoreTargets(results, ours);
  addBuilds(meshes, results);
  return rowsOf(results);
}

Rows benchmarkCoreCold(bool quick) {
  const QueryPath path = queryPath();
  const Suite suite = makeColdSuite(chooseMeshes(quick), nameOfOurs(path));
  useQueryPath(path);
  std::cout << "measuring " << suite.size() << " cases\n" << std::flush;
  const Results results = runCold(suite, quick ? 15 : 25);
  printCold(results, nameOfOurs(path));
  return rowsOf(results);
}

}  // namespace link_bounds::bench

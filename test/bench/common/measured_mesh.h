// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh on which all methods are measured.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/geometry/support/point_set.h"

namespace link_bounds::bench {

struct MeasuredMesh {
  std::string name;
  std::string kind;   ///< robot, model or synthetic
  TriangleMesh mesh;  ///< every vertex once, as the library keeps it
  std::shared_ptr<const PointSet> points;
  double build_ns = 0;  ///< to make `points`, once
};

using MeasuredMeshes = std::vector<MeasuredMesh>;

inline MeasuredMesh measuredMesh(std::string name, std::string kind, TriangleMesh mesh) {
  const auto start = std::chrono::steady_clock::now();
  auto points = std::make_shared<const PointSet>(mesh.vertices);
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  return {std::move(name), std::move(kind), std::move(mesh), std::move(points), time.count()};
}

}  // namespace link_bounds::bench

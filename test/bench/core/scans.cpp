// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact without preparation: every vertex in every update.
#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

/// As in the paper: each vertex of each triangle is transformed and compared. The vertices of one
/// triangle lie apart in memory, but each is there only once, which is quicker than a file's list
/// of loose triangles.
struct PaperLoop : EigenMethod {
  const TriangleMesh* mesh;

  explicit PaperLoop(const MeasuredMesh& source) : mesh(&source.mesh) {}

  Aabb box(const Pose& pose) const {
    Aabb result;
    for (const auto& triangle : mesh->triangles) {
      for (const std::uint32_t index : triangle)
        result.extend(pose * mesh->vertices[index].cast<double>());
    }
    return result;
  }

  std::size_t bytes() const {
    return mesh->vertices.size() * sizeof(mesh->vertices[0]) +
           mesh->triangles.size() * sizeof(mesh->triangles[0]);
  }
};

struct WeldedScan : EigenMethod {
  const std::vector<Eigen::Vector3f>* vertices;

  explicit WeldedScan(const MeasuredMesh& source) : vertices(&source.mesh.vertices) {}

  Aabb box(const Pose& pose) const {
    Aabb result;
    for (const Eigen::Vector3f& vertex : *vertices)
      result.extend(pose * vertex.cast<double>());
    return result;
  }

  std::size_t bytes() const { return vertices->size() * sizeof((*vertices)[0]); }
};

}  // namespace

void addScans(const Trial& trial, Suite& suite) {
  addCase("paper_loop", trial.mesh, trial.turning, PaperLoop(trial.mesh), suite);
  addCase("welded_scan", trial.mesh, trial.turning, WeldedScan(trial.mesh), suite);
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// geometric_shapes, which MoveIt builds on: a convex mesh under a pose.
#include <geometric_shapes/bodies.h>
#include <geometric_shapes/mesh_operations.h>

#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

struct GeometricShapes : EigenMethod {
  std::shared_ptr<bodies::ConvexMesh> body;

  explicit GeometricShapes(const MeasuredMesh& source) {
    EigenSTL::vector_Vector3d vertices;
    for (const Eigen::Vector3f& vertex : source.mesh.vertices)
      vertices.push_back(vertex.cast<double>());
    std::vector<unsigned int> triangles;
    for (const auto& triangle : source.mesh.triangles)
      triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    const std::unique_ptr<shapes::Mesh> mesh(shapes::createMeshFromVertices(vertices, triangles));
    body = std::make_shared<bodies::ConvexMesh>(mesh.get());
  }

  /// Qhull gives up on flat meshes.
  bool hasHull() const { return !body->getVertices().empty(); }

  bodies::AABB box(const Pose& pose) const {
    bodies::AABB result;
    body->setPose(pose);
    body->computeBoundingBox(result);
    return result;
  }

  std::size_t bytes() const { return 0; }
};

}  // namespace

void addGeometricShapes(const Trial& trial, Suite& suite) {
  const GeometricShapes method(trial.mesh);
  if (method.hasHull()) addCase("geometric_shapes", trial.mesh, trial.turning, method, suite);
}

}  // namespace link_bounds::bench

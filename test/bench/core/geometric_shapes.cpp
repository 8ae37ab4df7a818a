// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// geometric_shapes, which MoveIt builds on: a convex mesh under a pose.
#include "bench/common/convex_mesh.h"
#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

struct GeometricShapes : EigenMethod {
  std::shared_ptr<bodies::ConvexMesh> body;

  explicit GeometricShapes(const MeasuredMesh& source) {
    EigenSTL::vector_Vector3d vertices;
    for (const Eigen::Vector3f& vertex : source.mesh.vertices)
      vertices.push_back(vertex.cast<double>());
    body = convexMesh(vertices);
  }

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

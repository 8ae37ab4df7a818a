// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// geometric_shapes, on which MoveIt builds: its ConvexMesh under a pose.
#include "core_suite.h"

#ifdef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
#include <geometric_shapes/bodies.h>
#include <geometric_shapes/mesh_operations.h>

namespace link_bounds::bench {
namespace {

struct GeometricShapes : Method {
  std::shared_ptr<bodies::ConvexMesh> body;

  explicit GeometricShapes(const Mesh& mesh) {
    EigenSTL::vector_Vector3d vertices;
    for (const Eigen::Vector3f& vertex : mesh.mesh.vertices)
      vertices.push_back(vertex.cast<double>());
    std::vector<unsigned int> triangles;
    for (const auto& triangle : mesh.mesh.triangles)
      triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    const std::unique_ptr<shapes::Mesh> shape(shapes::createMeshFromVertices(vertices, triangles));
    body = std::make_shared<bodies::ConvexMesh>(shape.get());
  }

  Eigen::Isometry3d prepare(const Eigen::Affine3d& pose) const {
    return Eigen::Isometry3d(pose.matrix());
  }
  bodies::AABB box(const Eigen::Isometry3d& pose) const {
    bodies::AABB result;
    body->setPose(pose);
    body->computeBoundingBox(result);
    return result;
  }
  Aabb toAabb(const bodies::AABB& box) const { return box; }
  std::size_t bytes() const { return body->getVertices().size() * sizeof(Eigen::Vector3d); }
};

}  // namespace

void addGeometricShapes(const Task& task) {
  addCase("geometric_shapes", task, GeometricShapes(task.mesh));
}

}  // namespace link_bounds::bench
#else
void link_bounds::bench::addGeometricShapes(const Task&) {}
#endif

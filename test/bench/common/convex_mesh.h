// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A convex hull of geometric_shapes.
#pragma once

#include <geometric_shapes/bodies.h>
#include <geometric_shapes/mesh_operations.h>

#include <memory>
#include <vector>

namespace link_bounds::bench {

/// Without vertices where Qhull gives up, as on flat meshes. Triangles do not matter to it.
inline std::shared_ptr<bodies::ConvexMesh> convexMesh(const EigenSTL::vector_Vector3d& points) {
  std::vector<unsigned int> triangles;
  for (unsigned int i = 0; i + 2 < points.size(); i += 3)
    triangles.insert(triangles.end(), {i, i + 1, i + 2});
  const std::unique_ptr<shapes::Mesh> mesh(shapes::createMeshFromVertices(points, triangles));
  return std::make_shared<bodies::ConvexMesh>(mesh.get());
}

}  // namespace link_bounds::bench

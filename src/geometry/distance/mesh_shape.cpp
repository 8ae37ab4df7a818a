// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A vertex that no triangle uses is no point of the body, so no distance may rest on it.
#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {
namespace {

std::vector<Eigen::Vector3f> usedVertices(const TriangleMesh& mesh) {
  std::vector<bool> is_used(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle)
      is_used[vertex] = true;
  }
  std::vector<Eigen::Vector3f> result;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (is_used[i]) result.push_back(mesh.vertices[i]);
  }
  return result;
}

}  // namespace

std::optional<BodyShape> meshShape(const TriangleMesh& mesh, const Eigen::Affine3d& link_from_mesh,
                                   const CheckInterrupt& check_interrupt) {
  auto triangles = triangleTree(mesh, check_interrupt);
  if (!triangles) return std::nullopt;
  BodyShape result;
  result.shape.points = std::make_shared<const PointSet>(usedVertices(mesh), check_interrupt);
  result.shape.link_from_shape = link_from_mesh;
  result.triangles = std::move(triangles);
  return result;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids of vertices on the faces of a box, and a spiral on a sphere.
#include <Eigen/Geometry>
#include <cmath>

#include "bench/common/mesh_choice.h"
#include "robot/mesh/weld.h"

namespace link_bounds::bench {
namespace {

using Index = std::uint32_t;

/// Adds the parallelogram origin + s u + t v, with s and t in [0, 1] and n * n squares.
void addFace(const Eigen::Vector3d& origin, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
             Index n, TriangleMesh& mesh) {
  const auto first = static_cast<Index>(mesh.vertices.size());
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j)
      mesh.vertices.push_back((origin + i * u / n + j * v / n).cast<float>());
  }
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index corner = first + i * (n + 1) + j;
      mesh.triangles.push_back({corner, corner + n + 1, corner + 1});
      mesh.triangles.push_back({corner + 1, corner + n + 1, corner + n + 2});
    }
  }
}

/// A flat box of 0.6 m * 0.4 m * 0.05 m, each face of 40 * 40 squares.
TriangleMesh tessellatedBox(const Eigen::Matrix3d& rotation) {
  constexpr Index kSquares = 40;
  const Eigen::Matrix3d edges = rotation * Eigen::Vector3d(0.6, 0.4, 0.05).asDiagonal();
  const Eigen::Vector3d low = edges * Eigen::Vector3d::Constant(-0.5);
  TriangleMesh mesh;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d u = edges.col((k + 1) % 3);
    const Eigen::Vector3d v = edges.col((k + 2) % 3);
    addFace(low, v, u, kSquares, mesh);
    addFace(low + edges.col(k), u, v, kSquares, mesh);
  }
  return welded(mesh);
}

/// A turn whose sine and cosine are 3/5 and 4/5, about two axes: rounding to float32 moves every
/// vertex of a face off its plane.
Eigen::Matrix3d tilt() {
  const double angle = std::atan2(3.0, 4.0);
  return (Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

/// A Fibonacci spiral. The triangles only serve to use every vertex.
TriangleMesh sphere(Index count, double radius) {
  const double golden_angle = M_PI * (3 - std::sqrt(5.0));
  TriangleMesh mesh;
  for (Index i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count;
    const double width = std::sqrt(1 - z * z);
    const Eigen::Vector3d direction(width * std::cos(i * golden_angle),
                                    width * std::sin(i * golden_angle), z);
    mesh.vertices.push_back((radius * direction).cast<float>());
    if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  return welded(mesh);
}

}  // namespace

void addSyntheticMeshes(MeasuredMeshes& meshes) {
  const auto add = [&meshes](const char* name, TriangleMesh mesh) {
    meshes.push_back(measuredMesh(name, "synthetic", std::move(mesh)));
  };
  add("tessellated box", tessellatedBox(Eigen::Matrix3d::Identity()));
  add("tessellated box, tilted", tessellatedBox(tilt()));
  add("sphere of 10,000 points", sphere(10000, 0.5));
}

}  // namespace link_bounds::bench

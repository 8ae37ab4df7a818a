// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies for tests of distances, with the triangles that an oracle needs.
#pragma once

#include "link_bounds/geometry/distance/body_distance.h"
#include "testing/brute_force.h"
#include "testing/distance_oracle.h"

namespace link_bounds {

/// A body of one or more meshes, in its own frame.
struct MeshBody {
  Body body;
  std::vector<TriangleMesh> meshes;

  void add(const TriangleMesh& mesh,
           const Eigen::Affine3d& link_from_mesh = Eigen::Affine3d::Identity()) {
    body.shapes.push_back(*meshShape(mesh, link_from_mesh));
    meshes.push_back(mesh);
  }

  template <class Real = distance_oracle::Long>
  std::vector<distance_oracle::TriangleOf<Real>> placed(
      const Eigen::Affine3d& world_from_body) const {
    std::vector<distance_oracle::TriangleOf<Real>> result;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const auto triangles = distance_oracle::placed<Real>(
          meshes[i], body.shapes[i].shape.link_from_shape, world_from_body);
      result.insert(result.end(), triangles.begin(), triangles.end());
    }
    return result;
  }
};

/// Every three vertices are a triangle.
inline TriangleMesh meshOf(const std::vector<Eigen::Vector3f>& vertices) {
  TriangleMesh mesh{vertices, {}};
  for (std::uint32_t i = 0; i + 2 < vertices.size(); i += 3)
    mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

/// The twelve triangles of a box around the origin.
inline TriangleMesh boxMesh(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(corner.cwiseProduct(size).cast<float>());
  }
  for (const auto& quad : kQuads) {
    std::array<std::uint32_t, 4> q;
    for (std::size_t k = 0; k < 4; ++k)
      q[k] = static_cast<std::uint32_t>(quad[k]);
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

/// Triangles of very different form in a cube of half width `size`: a soup, needles, a plate,
/// segments, points, equal points, or a closed box.
inline TriangleMesh anyMesh(brute_force::Random& random, double size, double max_triangles = 40) {
  const auto count = static_cast<std::size_t>(std::pow(max_triangles, random.uniform(0, 1)));
  const int kind = static_cast<int>(random.uniform(0, 7));
  if (kind == 0) return boxMesh(random.vector(size).cwiseAbs());
  std::vector<Eigen::Vector3f> vertices = random.points(3 * count, size);
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const auto near = static_cast<float>(0.05 * size);
    if (kind == 1 || kind == 2) {
      vertices[i + 1] = vertices[i] + near * random.vector(1).cast<float>();
      if (kind == 2) vertices[i + 2] = vertices[i] + near * random.vector(1).cast<float>();
    }
    if (kind == 3) vertices[i].z() = vertices[i + 1].z() = vertices[i + 2].z() = near;
    if (kind == 4) vertices[i + 2] = vertices[i + 1];
    if (kind == 5) vertices[i + 2] = vertices[i + 1] = vertices[i];
  }
  if (kind == 6 && count > 1) std::fill(vertices.begin() + 3, vertices.end(), vertices[0]);
  return meshOf(vertices);
}

/// A closed surface with bumps, of 2 * steps * steps triangles.
inline TriangleMesh bumpyBall(std::uint32_t steps, double bump) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    for (std::uint32_t j = 0; j <= steps; ++j) {
      const double down = M_PI * i / steps, around = 2 * M_PI * j / steps;
      const double radius = 0.3 + bump * std::sin(5 * down) * std::sin(7 * around);
      mesh.vertices.push_back(
          (radius * Eigen::Vector3d(std::sin(down) * std::cos(around),
                                    std::sin(down) * std::sin(around), std::cos(down)))
              .cast<float>());
      if (i == steps || j == steps) continue;
      const std::uint32_t here = i * (steps + 1) + j, below = here + steps + 1;
      mesh.triangles.push_back({here, below, here + 1});
      mesh.triangles.push_back({here + 1, below, below + 1});
    }
  }
  return mesh;
}

/// A body of up to three meshes and cylinders, which may have tips; at times of none if `least` is
/// below 1.
inline std::shared_ptr<const Body> mixedBody(brute_force::Random& random, double least,
                                             bool has_tips) {
  auto body = std::make_shared<Body>();
  const int shapes = static_cast<int>(random.uniform(least, 4));
  for (int i = 0; i < shapes; ++i) {
    MeshBody mesh;
    mesh.add(anyMesh(random, 0.3), random.rigid(0.3));
    body->shapes.push_back(mesh.body.shapes[0]);
    if (random.sign() > 0) continue;
    body->shapes.back() = {
        {nullptr, Solid::kCylinder, random.vector(0.5).cwiseAbs(), random.rigid(0.3)}};
    if (has_tips && random.sign() > 0) body->shapes.back().tip = random.vector(0.5);
  }
  return body;
}

/// What BodyDistances should know of a body.
struct Twin {
  std::shared_ptr<const Body> body;
  std::optional<Eigen::Affine3d> pose;
};

/// How far a placed solid, with its tip, extends along `n` from the origin of the world, in long
/// double.
inline distance_oracle::Long solidSupport(const BodyShape& body_shape, const Eigen::Affine3d& pose,
                                          const Eigen::Vector3d& n) {
  using distance_oracle::Long;
  const Shape& shape = body_shape.shape;
  const Eigen::Transform<Long, 3, Eigen::Affine> world =
      pose.cast<Long>() * shape.link_from_shape.cast<Long>();
  const distance_oracle::Vector direction = n.cast<Long>();
  const distance_oracle::Vector row =
      (world.linear().transpose() * direction).cwiseProduct(shape.size.cast<Long>() / 2);
  const Long middle = direction.dot(world.translation());
  Long half = row.head<2>().norm() + std::abs(row.z());
  if (shape.solid == Solid::kNone) half = 0;
  if (shape.solid == Solid::kBox) half = row.cwiseAbs().sum();
  if (shape.solid == Solid::kEllipsoid) half = row.norm();
  if (!body_shape.tip) return middle + half;
  return std::max(middle + half, direction.dot(world * body_shape.tip->cast<Long>()));
}

}  // namespace link_bounds

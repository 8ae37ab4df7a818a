// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are worth splitting, made in code.
#pragma once

#include <functional>
#include <map>

#include "link_bounds/geometry/parts/link_parts.h"
#include "testing/brute_force.h"

namespace link_bounds {

inline DivisibleShape divisible(const TriangleMesh& mesh, const Eigen::Affine3d& link_from_shape =
                                                              Eigen::Affine3d::Identity()) {
  return {{std::make_shared<const PointSet>(mesh.vertices), Solid::kNone, Eigen::Vector3d::Zero(),
           link_from_shape},
          std::make_shared<const TriangleMesh>(mesh)};
}

inline DivisibleShape solid(Solid kind, const Eigen::Vector3d& size,
                            const Eigen::Vector3d& center) {
  return {{nullptr, kind, size, Eigen::Affine3d(Eigen::Translation3d(center))}, nullptr};
}

/// The same triangles with equal vertices merged.
inline TriangleMesh merged(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::map<std::array<float, 3>, std::uint32_t> index;
  for (auto triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      const Eigen::Vector3f vertex = mesh.vertices[corner].array() + 0.0f;  // no -0
      const auto next = static_cast<std::uint32_t>(result.vertices.size());
      const auto [known, is_new] = index.try_emplace({vertex.x(), vertex.y(), vertex.z()}, next);
      if (is_new) result.vertices.push_back(vertex);
      corner = known->second;
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

/// A surface over rows * columns squares of parameters in [0, 1].
inline TriangleMesh surface(std::uint32_t rows, std::uint32_t columns,
                            const std::function<Eigen::Vector3d(double, double)>& point) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= rows; ++i) {
    for (std::uint32_t j = 0; j <= columns; ++j)
      mesh.vertices.push_back(
          point(static_cast<double>(i) / rows, static_cast<double>(j) / columns).cast<float>());
  }
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t corner = i * (columns + 1) + j;
      mesh.triangles.push_back({corner, corner + columns + 1, corner + 1});
      mesh.triangles.push_back({corner + 1, corner + columns + 1, corner + columns + 2});
    }
  }
  return merged(mesh);
}

/// The surface of a ball of radius 1.
inline TriangleMesh ball(std::uint32_t rows, std::uint32_t columns) {
  return surface(rows, columns, [](double s, double t) -> Eigen::Vector3d {
    const double polar = M_PI * s;
    const double around = 2 * M_PI * t;
    return {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
            std::cos(polar)};
  });
}

/// A tilted tube of radius 0.1 along three quarters of a circle of radius 1. Most of its box is
/// empty.
inline TriangleMesh hook(std::uint32_t rows, std::uint32_t columns) {
  const Eigen::Matrix3d tilted = brute_force::turned(30, {1, 2, 3});
  return surface(rows, columns, [&tilted](double s, double t) -> Eigen::Vector3d {
    const double along = 1.5 * M_PI * s;
    const double around = 2 * M_PI * t;
    const double distance = 1 + 0.1 * std::cos(around);
    return tilted * Eigen::Vector3d(distance * std::cos(along), distance * std::sin(along),
                                    0.1 * std::sin(around));
  });
}

/// Small triangles all over a cube of half width 1.
inline TriangleMesh soup(std::uint32_t count, std::uint64_t seed) {
  brute_force::Random random(seed);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto corners = random.points(3, 0.1, random.vector(0.9));
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return merged(mesh);
}

inline Aabb boxOf(const std::vector<Shape>& shapes, const Eigen::Affine3d& world_from_link) {
  Aabb box;
  for (const Shape& shape : shapes)
    box.extend(worldBox(shape, world_from_link).value());
  return box;
}

inline double volumeOf(const std::vector<LinkPart>& parts, const Eigen::Affine3d& world_from_link) {
  double sum = 0;
  for (const LinkPart& part : parts)
    sum += boxOf(part, world_from_link).volume();
  return sum;
}

}  // namespace link_bounds

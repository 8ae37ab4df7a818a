// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two sets of triangles by comparing every two of them, in long double: what proven
// bounds are checked against. Shares no code with the library.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "link_bounds/geometry/parts/triangle_mesh.h"

namespace link_bounds::distance_oracle {

using Long = long double;
using Vector = Eigen::Matrix<Long, 3, 1>;
using Triangle = std::array<Vector, 3>;

inline Long distance(const Vector& p, const Vector& a, const Vector& b) {
  const Vector ab = b - a;
  const Long squared = ab.squaredNorm();
  const Long t = squared > 0 ? std::clamp<Long>((p - a).dot(ab) / squared, 0, 1) : 0;
  return (a + t * ab - p).norm();
}

/// Inside if p is on the inner side of all three edges; else an edge is nearest.
inline Long distance(const Vector& p, const Triangle& t) {
  Long result =
      std::min({distance(p, t[0], t[1]), distance(p, t[1], t[2]), distance(p, t[2], t[0])});
  const Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const Long length = normal.norm();
  if (!(length > 0)) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) >= 0)) return result;
  }
  return std::min(result, std::abs(normal.dot(p - t[0])) / length);
}

/// Of two lines where both nearest points are inside their segments; the ends are points.
inline Long distance(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Long ends =
      std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
  const Vector across = (b - a).cross(d - c);
  const Long squared = across.squaredNorm();
  if (!(squared > 0)) return ends;
  const Long s = (c - a).cross(d - c).dot(across) / squared;
  const Long t = (c - a).cross(b - a).dot(across) / squared;
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return ends;
  return std::min(ends, (a + s * (b - a) - c - t * (d - c)).norm());
}

inline bool pierces(const Vector& a, const Vector& b, const Triangle& t) {
  const auto volume = [](const Vector& p, const Vector& q, const Vector& r, const Vector& s) {
    return (q - p).cross(r - p).dot(s - p);
  };
  const Long above = volume(t[0], t[1], t[2], a), below = volume(t[0], t[1], t[2], b);
  if (!((above > 0 && below < 0) || (above < 0 && below > 0))) return false;
  const Long u = volume(a, b, t[0], t[1]), v = volume(a, b, t[1], t[2]),
             w = volume(a, b, t[2], t[0]);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

inline Long distance(const Triangle& a, const Triangle& b) {
  Long result = std::numeric_limits<Long>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (pierces(a[i], a[next], b) || pierces(b[i], b[next], a)) return 0;
    result = std::min({result, distance(a[i], b), distance(b[i], a)});
    for (std::size_t j = 0; j < 3; ++j)
      result = std::min(result, distance(a[i], a[next], b[j], b[(j + 1) % 3]));
  }
  return result;
}

/// Each corner at the exact product of both poses and the vertex, up to long double.
inline std::vector<Triangle> placed(const TriangleMesh& mesh, const Eigen::Affine3d& link_from_mesh,
                                    const Eigen::Affine3d& world_from_link) {
  using Pose = Eigen::Transform<Long, 3, Eigen::Affine>;
  const Pose pose = world_from_link.cast<Long>() * link_from_mesh.cast<Long>();
  std::vector<Triangle> result;
  for (const auto& triangle : mesh.triangles) {
    Triangle corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = pose * mesh.vertices[triangle[k]].cast<Long>();
    result.push_back(corners);
  }
  return result;
}

inline Long distance(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  Long result = std::numeric_limits<Long>::infinity();
  for (const Triangle& first : a) {
    for (const Triangle& second : b)
      result = std::min(result, distance(first, second));
  }
  return result;
}

inline Long distance(const Eigen::Vector3d& point, const std::vector<Triangle>& triangles) {
  Long result = std::numeric_limits<Long>::infinity();
  const Vector p = point.cast<Long>();
  for (const Triangle& triangle : triangles)
    result = std::min(result, distance(p, triangle));
  return result;
}

}  // namespace link_bounds::distance_oracle

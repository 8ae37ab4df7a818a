// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two sets of triangles by comparing every two of them, in long double or quadruple
// precision: what proven bounds are checked against. Shares no code with the library.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "testing/quad.h"

namespace link_bounds::distance_oracle {

using Long = long double;

template <class Real>
using VectorOf = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using TriangleOf = std::array<VectorOf<Real>, 3>;

using Vector = VectorOf<Long>;
using Triangle = TriangleOf<Long>;

inline Long root(Long square) {
  return std::sqrt(square);
}

#ifdef __SIZEOF_FLOAT128__
/// Newton's method doubles the number of right digits.
inline Quad root(Quad square) {
  Quad result = std::sqrt(static_cast<Long>(square));
  if (result > 0) result = (result + square / result) / 2;
  return result;
}
#endif

template <class Real>
Real length(const VectorOf<Real>& v) {
  return root(Real(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
}

template <class Real>
Real magnitude(Real x) {
  return x < 0 ? -x : x;
}

template <class Real>
Real distance(const VectorOf<Real>& p, const VectorOf<Real>& a, const VectorOf<Real>& b) {
  const VectorOf<Real> ab = b - a;
  const Real squared = ab.dot(ab);
  const VectorOf<Real> from = p - a;
  const Real t = squared > 0 ? std::clamp<Real>(from.dot(ab) / squared, 0, 1) : Real(0);
  return length<Real>(a + t * ab - p);
}

/// Inside if p is on the inner side of all three edges; else an edge is nearest.
template <class Real>
Real distance(const VectorOf<Real>& p, const TriangleOf<Real>& t) {
  const Real result =
      std::min({distance(p, t[0], t[1]), distance(p, t[1], t[2]), distance(p, t[2], t[0])});
  const VectorOf<Real> ab = t[1] - t[0], ac = t[2] - t[0];
  const VectorOf<Real> normal = ab.cross(ac);
  const Real size = length(normal);
  if (!(size > 0)) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    const VectorOf<Real> edge = t[(i + 1) % 3] - t[i], from = p - t[i];
    if (!(normal.dot(edge.cross(from)) >= 0)) return result;
  }
  const VectorOf<Real> from = p - t[0];
  return std::min<Real>(result, magnitude<Real>(normal.dot(from)) / size);
}

/// Of two lines where both nearest points are inside their segments; the ends are points.
template <class Real>
Real distance(const VectorOf<Real>& a, const VectorOf<Real>& b, const VectorOf<Real>& c,
              const VectorOf<Real>& d) {
  const Real ends =
      std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
  const VectorOf<Real> ab = b - a, cd = d - c, ac = c - a;
  const VectorOf<Real> across = ab.cross(cd);
  const Real squared = across.dot(across);
  if (!(squared > 0)) return ends;
  const Real s = ac.cross(cd).dot(across) / squared;
  const Real t = ac.cross(ab).dot(across) / squared;
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return ends;
  return std::min<Real>(ends, length<Real>(a + s * ab - c - t * cd));
}

template <class Real>
bool pierces(const VectorOf<Real>& a, const VectorOf<Real>& b, const TriangleOf<Real>& t) {
  const auto volume = [](const VectorOf<Real>& p, const VectorOf<Real>& q, const VectorOf<Real>& r,
                         const VectorOf<Real>& s) {
    const VectorOf<Real> pq = q - p, pr = r - p, ps = s - p;
    return pq.cross(pr).dot(ps);
  };
  const Real above = volume(t[0], t[1], t[2], a), below = volume(t[0], t[1], t[2], b);
  if (!((above > 0 && below < 0) || (above < 0 && below > 0))) return false;
  const Real u = volume(a, b, t[0], t[1]), v = volume(a, b, t[1], t[2]),
             w = volume(a, b, t[2], t[0]);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

template <class Real>
Real distance(const TriangleOf<Real>& a, const TriangleOf<Real>& b) {
  Real result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (pierces<Real>(a[i], a[next], b) || pierces<Real>(b[i], b[next], a)) return 0;
    result = std::min({result, distance<Real>(a[i], b), distance<Real>(b[i], a)});
    for (std::size_t j = 0; j < 3; ++j)
      result = std::min(result, distance<Real>(a[i], a[next], b[j], b[(j + 1) % 3]));
  }
  return result;
}

/// Each corner at the exact product of both poses and the vertex, up to Real.
template <class Real = Long>
std::vector<TriangleOf<Real>> placed(const TriangleMesh& mesh,
                                     const Eigen::Affine3d& link_from_mesh,
                                     const Eigen::Affine3d& world_from_link) {
  using Matrix = Eigen::Matrix<Real, 3, 3>;
  const Matrix outer = world_from_link.linear().cast<Real>();
  const Matrix inner = link_from_mesh.linear().cast<Real>();
  const VectorOf<Real> outer_at = world_from_link.translation().cast<Real>();
  const VectorOf<Real> inner_at = link_from_mesh.translation().cast<Real>();
  std::vector<TriangleOf<Real>> result;
  for (const auto& triangle : mesh.triangles) {
    TriangleOf<Real> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const VectorOf<Real> vertex = mesh.vertices[triangle[k]].cast<Real>();
      const VectorOf<Real> in_link = inner * vertex + inner_at;
      corners[k] = outer * in_link + outer_at;
    }
    result.push_back(corners);
  }
  return result;
}

inline Long distance(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  Long result = std::numeric_limits<Long>::infinity();
  for (const Triangle& first : a) {
    for (const Triangle& second : b)
      result = std::min(result, distance<Long>(first, second));
  }
  return result;
}

/// As above where it is less than `start`, else `start`. Two triangles whose axis-aligned boxes are
/// farther apart than two others are not compared further.
inline Long distance(const std::vector<Triangle>& a, const std::vector<Triangle>& b, Long start) {
  using Box = Eigen::AlignedBox<Long, 3>;
  const auto boxOf = [](const Triangle& triangle) {
    return Box(triangle[0]).extend(triangle[1]).extend(triangle[2]);
  };
  std::vector<Box> boxes;
  for (const Triangle& triangle : b)
    boxes.push_back(boxOf(triangle));
  Long result = start;
  for (const Triangle& first : a) {
    const Box box = boxOf(first);
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (box.squaredExteriorDistance(boxes[j]) <= result * result)
        result = std::min(result, distance<Long>(first, b[j]));
    }
  }
  return result;
}

/// In quadruple precision, which takes two hundred times as long. Only triangles count that are
/// within `slack` of `nearest`, the distance in long double.
inline Quad quadDistance(const std::vector<Triangle>& a, const std::vector<Triangle>& b,
                         const std::vector<TriangleOf<Quad>>& exact_a,
                         const std::vector<TriangleOf<Quad>>& exact_b, Long nearest, Long slack) {
  Quad result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (distance<Long>(a[i], b[j]) <= nearest + slack)
        result = std::min(result, distance<Quad>(exact_a[i], exact_b[j]));
    }
  }
  return result;
}

inline Long distance(const Eigen::Vector3d& point, const std::vector<Triangle>& triangles) {
  Long result = std::numeric_limits<Long>::infinity();
  const Vector p = point.cast<Long>();
  for (const Triangle& triangle : triangles)
    result = std::min(result, distance<Long>(p, triangle));
  return result;
}

}  // namespace link_bounds::distance_oracle

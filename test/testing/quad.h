// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes in quadruple precision, in which a double times a float or a double is exact: what a claim
// about rounding is checked against. Points are float or double.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

#ifdef __SIZEOF_FLOAT128__
using Quad = __float128;
#else
using Quad = long double;  // quadruple on the other machines that Debian knows, as arm64
#endif

inline Quad quadRoot(Quad square) {
  if (square <= 0) return 0;
  Quad root = std::sqrt(static_cast<double>(square));
  for (int i = 0; i < 2; ++i)
    root = (root + square / root) / 2;
  return root;
}

/// By its series, for |x| <= pi/2.
inline Quad quadSine(Quad x) {
  Quad term = x, sum = x;
  for (int n = 2; n < 40; n += 2) {
    term *= -x * x / (n * (n + 1));
    sum += term;
  }
  return sum;
}

struct QuadBox {
  std::array<Quad, 3> min;
  std::array<Quad, 3> max;
};

template <class Point>
Quad exactCoordinate(const Eigen::Affine3d& pose, int axis, const Point& point) {
  Quad sum = pose.translation()[axis];
  for (int j = 0; j < 3; ++j) {
    sum += static_cast<Quad>(pose.linear()(axis, j)) * static_cast<Quad>(point[j]);
  }
  return sum;
}

template <class Point>
QuadBox exactBox(const std::vector<Point>& points, const Eigen::Affine3d& pose) {
  QuadBox result;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    result.min[i] = result.max[i] = exactCoordinate(pose, k, points.front());
    for (const Point& point : points) {
      const Quad coordinate = exactCoordinate(pose, k, point);
      result.min[i] = std::min(result.min[i], coordinate);
      result.max[i] = std::max(result.max[i], coordinate);
    }
  }
  return result;
}

inline bool contains(const Aabb& outer, const QuadBox& inner) {
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (static_cast<Quad>(outer.min()[k]) > inner.min[i]) return false;
    if (static_cast<Quad>(outer.max()[k]) < inner.max[i]) return false;
  }
  return true;
}

/// How far the faces of `outer` across `axis` lie outside those of `inner`, the larger of the two.
inline double excess(const Aabb& outer, const QuadBox& inner, int axis) {
  const auto i = static_cast<std::size_t>(axis);
  return static_cast<double>(std::max(inner.min[i] - static_cast<Quad>(outer.min()[axis]),
                                      static_cast<Quad>(outer.max()[axis]) - inner.max[i]));
}

template <class Point>
double largestCoordinate(const std::vector<Point>& points) {
  double result = 0;
  for (const Point& point : points)
    result = std::max<double>(result, point.cwiseAbs().maxCoeff());
  return result;
}

/// What shape.h admits for vertices that reach so far from their origin.
inline double allowedExcess(const Eigen::Affine3d& pose, int axis, double reach) {
  constexpr double kPerReach = 4e-14;        // of A |r|_1
  constexpr double kPerTranslation = 2e-15;  // of |t|
  return kPerReach * reach * pose.linear().row(axis).lpNorm<1>() +
         kPerTranslation * std::abs(pose.translation()[axis]);
}

/// Why worldBox() must not give this box of the points; "" if it may. `slack` [m] is admitted
/// beyond allowedExcess().
template <class Point>
std::string faultOf(const Aabb& box, const std::vector<Point>& points, const Eigen::Affine3d& pose,
                    double slack = 0) {
  const QuadBox exact = exactBox(points, pose);
  if (!contains(box, exact)) return "a vertex is outside of the box";
  for (int k = 0; k < 3; ++k) {
    const double allowed = allowedExcess(pose, k, largestCoordinate(points)) + slack;
    if (!(excess(box, exact, k) <= allowed)) return "the box is larger than its pad explains";
  }
  return "";
}

}  // namespace link_bounds

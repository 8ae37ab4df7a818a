// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The smallest sphere around points by Welzl's algorithm (1991), in long double.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "link_bounds/geometry/volumes/bounding_sphere.h"
#include "testing/sampled_links.h"

namespace link_bounds::brute_force {

struct Sphere {
  LongVector center = LongVector::Zero();
  long double radius = -1;  ///< negative: contains no point

  bool contains(const LongVector& point) const {
    constexpr long double kSlack = 1e-14L;
    return (point - center).norm() <= radius * (1 + kSlack) + kSlack;
  }
};

/// The smallest sphere with up to four points on its surface. If they are in one plane or on one
/// line, a redundant point is left out.
inline Sphere throughPoints(const std::vector<LongVector>& points) {
  if (points.empty()) return {};
  Eigen::Matrix<long double, 3, 3> gram = LongMatrix::Identity();
  LongVector half_squares = LongVector::Zero();
  Eigen::Matrix<long double, 3, 3> edges = LongMatrix::Zero();
  for (std::size_t i = 1; i < points.size(); ++i)
    edges.col(static_cast<Eigen::Index>(i) - 1) = points[i] - points[0];
  const Eigen::Index count = static_cast<Eigen::Index>(points.size()) - 1;
  gram.topLeftCorner(count, count) = (edges.transpose() * edges).topLeftCorner(count, count);
  half_squares.head(count) = edges.colwise().squaredNorm().transpose().head(count) / 2;
  const LongVector offset = edges * gram.fullPivLu().solve(half_squares);
  return {points[0] + offset, offset.norm()};
}

/// The smallest sphere around the first `count` points that has the points `surface` on its
/// surface.
inline Sphere welzl(std::vector<LongVector>& points, std::size_t count,
                    std::vector<LongVector> surface) {
  Sphere sphere = throughPoints(surface);
  if (surface.size() == 4) return sphere;
  for (std::size_t i = 0; i < count; ++i) {
    if (sphere.contains(points[i])) continue;
    std::vector<LongVector> more = surface;
    more.push_back(points[i]);
    sphere = welzl(points, i, more);
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i),
                points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return sphere;
}

inline Sphere smallestSphere(std::vector<LongVector> points) {
  return welzl(points, points.size(), {});
}

}  // namespace link_bounds::brute_force

namespace link_bounds {

constexpr double kTolerance = 1e-6;  // of the radius
constexpr double kRounding = 1e-12;  // of the magnitude

inline void expectSphere(const BoundedLink& link, const Eigen::Vector3d& center, double radius) {
  const auto sphere = boundingSphere(link);
  ASSERT_TRUE(sphere);
  EXPECT_GE(sphere->radius, radius);
  EXPECT_LE(sphere->radius, radius * (1 + kTolerance) + kRounding * magnitude(link));
  // The smallest sphere is unique. The centre of one that is larger by a fraction e can be off by
  // sqrt(e) of the radius.
  EXPECT_LE((sphere->center - center).norm(),
            2 * std::sqrt(kTolerance) * radius + kRounding * magnitude(link));
}

inline void expectSmallest(const std::vector<Eigen::Vector3f>& points) {
  const BoundedLink link = linkOf({meshShape(points)});
  const auto smallest = brute_force::smallestSphere(pointsOf(link));
  expectSphere(link, smallest.center.cast<double>(), static_cast<double>(smallest.radius));
}

}  // namespace link_bounds

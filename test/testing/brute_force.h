// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The oracle: a scan over all vertices, and the random numbers to feed it with.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/support/point_set.h"

namespace link_bounds::brute_force {

/// r . p in the one order of operations that the library promises. Here and below points may be
/// float, as vertices of meshes, or double, as those of markers.
template <class Point>
double reach(const Eigen::Vector3d& row, const Point& point) {
  const double x = point.x();
  const double y = point.y();
  const double z = point.z();
  return (row.x() * x + row.y() * y) + row.z() * z;
}

template <class Point>
Extents extents(const std::vector<Point>& points, const Eigen::Matrix3d& directions) {
  Extents result;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d row = directions.row(k);
    result.low[k] = result.high[k] = reach(row, points.front());
    for (const Point& point : points) {
      result.low[k] = std::min(result.low[k], reach(row, point));
      result.high[k] = std::max(result.high[k], reach(row, point));
    }
  }
  return result;
}

/// The exact box up to the rounding of its evaluation.
template <class Point>
Aabb box(const std::vector<Point>& points, const Eigen::Affine3d& pose) {
  const Extents local = extents(points, pose.linear());
  return {local.low + pose.translation(), local.high + pose.translation()};
}

inline Eigen::Matrix3d turned(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()).toRotationMatrix();
}

/// The same numbers on every machine, unlike the distributions of <random>.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }

  /// 10^e with e uniform.
  double magnitude(double low_exponent, double high_exponent) {
    return std::pow(10.0, uniform(low_exponent, high_exponent));
  }

  double sign() { return engine_() & 1 ? 1.0 : -1.0; }

  /// In a cube of half width `size`.
  Eigen::Vector3d vector(double size) {
    const double x = uniform(-size, size);
    const double y = uniform(-size, size);
    const double z = uniform(-size, size);
    return {x, y, z};
  }

  Eigen::Matrix3d rotation() {
    Eigen::Quaterniond q;
    do {
      q = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    } while (q.norm() > 1 || q.norm() < 0.1);
    return q.normalized().toRotationMatrix();
  }

  Eigen::Affine3d rigid(double translation) { return placed(rotation(), translation); }

  /// Turned, scaled differently along tilted axes (so sheared) and often mirrored.
  Eigen::Affine3d affine(double translation) {
    const Eigen::Matrix3d first = rotation();
    Eigen::Vector3d scale;
    for (int k = 0; k < 3; ++k) {
      const double sign = engine_() & 1 ? 1 : -1;
      scale[k] = sign * magnitude(-2, 1);
    }
    return placed(rotation() * scale.asDiagonal() * first, translation);
  }

  /// In a cube of half width `size` around `center`.
  std::vector<Eigen::Vector3f> points(std::size_t count, double size,
                                      const Eigen::Vector3d& center = Eigen::Vector3d::Zero()) {
    std::vector<Eigen::Vector3f> result;
    for (std::size_t i = 0; i < count; ++i) {
      result.push_back((center + vector(size)).cast<float>());
    }
    return result;
  }

 private:
  Eigen::Affine3d placed(const Eigen::Matrix3d& linear, double translation) {
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    result.linear() = linear;
    result.translation() = vector(translation);
    return result;
  }

  std::mt19937_64 engine_;
};

}  // namespace link_bounds::brute_force

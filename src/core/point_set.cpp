// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The plain scan: every point against every direction, the paper's Figure 4 after welding.
#include "link_bounds/point_set.h"

#include <algorithm>

namespace link_bounds {

PointSet::PointSet(const std::vector<Eigen::Vector3f>& points)
    : magnitude_(Eigen::Vector3d::Zero()) {
  x_.reserve(points.size());
  y_.reserve(points.size());
  z_.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    x_.push_back(point.x());
    y_.push_back(point.y());
    z_.push_back(point.z());
    magnitude_ = magnitude_.cwiseMax(point.cast<double>().cwiseAbs());
  }
}

Extents PointSet::extents(const Eigen::Matrix3d& directions) const {
  Extents result;
  for (int k = 0; k < 3; ++k) {
    const double r0 = directions(k, 0);
    const double r1 = directions(k, 1);
    const double r2 = directions(k, 2);
    double low = (r0 * x_[0] + r1 * y_[0]) + r2 * z_[0];
    double high = low;
    for (std::size_t i = 1; i < x_.size(); ++i) {
      const double reach = (r0 * x_[i] + r1 * y_[i]) + r2 * z_[i];
      low = std::min(low, reach);
      high = std::max(high, reach);
    }
    result.low[k] = low;
    result.high[k] = high;
  }
  return result;
}

std::size_t PointSet::bytes() const {
  return sizeof(*this) + (x_.capacity() + y_.capacity() + z_.capacity()) * sizeof(float);
}

}  // namespace link_bounds

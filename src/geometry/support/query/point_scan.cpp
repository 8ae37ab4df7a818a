// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The plain path, and the magnitude.
#include <algorithm>
#include <cmath>

#include "geometry/support/query/direction_query.h"

namespace link_bounds {

Extents scanPlain(const double* xyz, std::size_t count, const Directions& directions) {
  Extents result;
  for (int k = 0; k < 3; ++k) {
    const double r0 = directions(k, 0);
    const double r1 = directions(k, 1);
    const double r2 = directions(k, 2);
    double low = (r0 * xyz[0] + r1 * xyz[1]) + r2 * xyz[2];
    double high = low;
    for (const double* point = xyz + 3; point != xyz + 3 * count; point += 3) {
      const double dot = (r0 * point[0] + r1 * point[1]) + r2 * point[2];
      low = std::min(low, dot);
      high = std::max(high, dot);
    }
    result.low[k] = low + 0.0;  // from -0 to +0, whichever came first
    result.high[k] = high + 0.0;
  }
  return result;
}

/// Four points at a time, so that the twelve numbers fill whole vectors.
Eigen::Vector3d scannedMagnitude(const double* xyz, std::size_t count) {
  using Twelve = Eigen::Array<double, 12, 1>;
  Twelve largest = Twelve::Zero();
  const double* const end = xyz + 3 * count;
  for (; end - xyz >= 12; xyz += 12)
    largest = largest.max(Eigen::Map<const Twelve>(xyz).abs());
  for (int i = 0; xyz != end; ++i, ++xyz)
    largest[i] = std::max(largest[i], std::abs(*xyz));
  return Eigen::Map<const Eigen::Matrix<double, 3, 4>>(largest.data()).rowwise().maxCoeff();
}

Extents scannedExtents(const double* xyz, std::size_t count, const Directions& directions) {
  return (count < kLanes ? kPlainQuery : query()).scan_all(xyz, count, directions);
}

}  // namespace link_bounds

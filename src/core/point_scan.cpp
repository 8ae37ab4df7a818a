// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loops over four lanes, which the compiler turns into vector instructions: those that every
// processor of the kind has and, compiled once more, AVX2. Minima and maxima are chosen by
// comparison and not by std::min, because only so they are single instructions without leave to
// mistreat what is not a number.
#include "point_scan.h"

#include <algorithm>

namespace link_bounds {
namespace {

constexpr int kLanes = 4;

/// Three rows and the range of r . p per lane.
struct Ranges {
  double low[3][kLanes];
  double high[3][kLanes];
};

inline __attribute__((always_inline)) void reach(const double* block, const double (&r)[3][3],
                                                 int k, double (&result)[kLanes]) {
  for (int lane = 0; lane < kLanes; ++lane) {
    result[lane] = (r[k][0] * block[lane] + r[k][1] * block[kLanes + lane]) +
                   r[k][2] * block[2 * kLanes + lane];
  }
}

inline __attribute__((always_inline)) Extents scan(const PointLanes& lanes,
                                                   const Directions& directions) {
  double r[3][3];
  Ranges ranges;
  for (int k = 0; k < 3; ++k) {
    for (int column = 0; column < 3; ++column)
      r[k][column] = directions(k, column);
    reach(lanes.data(), r, k, ranges.low[k]);
    reach(lanes.data(), r, k, ranges.high[k]);
  }
  const double* const end = lanes.data() + lanes.size();
  for (const double* block = lanes.data(); block != end; block += 3 * kLanes) {
    for (int k = 0; k < 3; ++k) {
      double next[kLanes];
      reach(block, r, k, next);
      for (int lane = 0; lane < kLanes; ++lane) {
        ranges.low[k][lane] = next[lane] < ranges.low[k][lane] ? next[lane] : ranges.low[k][lane];
        ranges.high[k][lane] =
            next[lane] > ranges.high[k][lane] ? next[lane] : ranges.high[k][lane];
      }
    }
  }
  Extents result;
  for (int k = 0; k < 3; ++k) {
    // From -0 to +0, whichever the order of comparisons has left.
    result.low[k] = *std::min_element(ranges.low[k], ranges.low[k] + kLanes) + 0.0;
    result.high[k] = *std::max_element(ranges.high[k], ranges.high[k] + kLanes) + 0.0;
  }
  return result;
}

Extents scanPlain(const PointLanes& lanes, const Directions& directions) {
  return scan(lanes, directions);
}

#ifdef __SSE2__
__attribute__((target("avx2"))) Extents scanAvx2(const PointLanes& lanes,
                                                 const Directions& directions) {
  return scan(lanes, directions);
}
#endif

}  // namespace

PointLanes packed(const DoublePoints& points, Eigen::Vector3d& magnitude) {
  const Eigen::Index count = points.cols();
  const Eigen::Index whole = count / kLanes * kLanes;
  PointLanes lanes(kLanes, (count + kLanes - 1) / kLanes * 3);
  double largest[3 * kLanes] = {};
  const auto add = [&](double* block, Eigen::Index first, Eigen::Index last) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double* point = points.col(std::min(first + lane, last)).data();
      for (int axis = 0; axis < 3; ++axis)
        block[axis * kLanes + lane] = point[axis];
    }
    for (int i = 0; i < 3 * kLanes; ++i) {
      const double next = std::abs(block[i]);
      largest[i] = next > largest[i] ? next : largest[i];
    }
  };
  double* block = lanes.data();
  for (Eigen::Index first = 0; first < whole; first += kLanes, block += 3 * kLanes)
    add(block, first, first + kLanes - 1);
  if (whole < count) add(block, whole, count - 1);
  for (int axis = 0; axis < 3; ++axis) {
    const double* const lane = largest + axis * kLanes;
    magnitude[axis] = *std::max_element(lane, lane + kLanes);
  }
  return lanes;
}

Extents scannedExtents(const PointLanes& lanes, const Directions& directions) {
#ifdef __SSE2__
  if (queryPath() == QueryPath::kAvx2) return scanAvx2(lanes, directions);
#endif
  return scanPlain(lanes, directions);
}

}  // namespace link_bounds

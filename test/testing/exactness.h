// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extents of the table beside those of the scan over all points, bit by bit.
#pragma once

#include "geometry/support/query/direction_query.h"
#include "link_bounds/geometry/box/rounding.h"
#include "link_bounds/geometry/support/point_set.h"
#include "testing/brute_force.h"

namespace link_bounds {

/// What a comparison found.
struct Exactness {
  long compared = 0;  ///< faces
  long ties = 0;      ///< faces that differ by no more than rounding, where points tie
  long wrong = 0;     ///< faces that differ by more, or between paths of instructions
  Eigen::Matrix3d wrong_map = Eigen::Matrix3d::Zero();

  Exactness& operator+=(const Exactness& other) {
    compared += other.compared;
    ties += other.ties;
    if (other.wrong > 0) wrong_map = other.wrong_map;
    wrong += other.wrong;
    return *this;
  }
};

inline void compareFace(double actual, double expected, double tie, Exactness& result) {
  ++result.compared;
  if (actual == expected) return;
  ++(std::abs(actual - expected) <= tie ? result.ties : result.wrong);
}

/// By all paths of instructions that this processor has; they must agree to the bit, also where
/// points tie.
inline Exactness compare(const std::vector<Eigen::Vector3f>& points, const PointSet& set,
                         const Eigen::Matrix3d& map) {
  Exactness result;
  const Extents expected = brute_force::extents(points, map);
  useQueryPath(QueryPath::kPlain);
  const Extents plain = set.extents(map);
  for (const QueryPath path : kQueryPaths) {
    if (!isSupported(path)) continue;
    useQueryPath(path);
    const Extents actual = set.extents(map);
    for (int k = 0; k < 3; ++k) {
      const double tie = 4 * kUnitRoundoff * map.row(k).cwiseAbs().dot(set.magnitude());
      compareFace(actual.low[k], expected.low[k], tie, result);
      compareFace(actual.high[k], expected.high[k], tie, result);
      result.wrong += actual.low[k] == plain.low[k] && actual.high[k] == plain.high[k] ? 0 : 1;
    }
  }
  if (result.wrong > 0) result.wrong_map = map;
  return result;
}

}  // namespace link_bounds

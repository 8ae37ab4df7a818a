// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two convex sets by their supports (Gilbert, Johnson and Keerthi, 1988).
#pragma once

#include <limits>

#include "geometry/distance/convex_sets.h"
#include "geometry/distance/simplex.h"

namespace link_bounds {

/// When the iteration may end. Lengths are metres.
struct GjkGoal {
  double enough;     ///< the lower bound need not be larger
  double too_near;   ///< ends as soon as the distance is proven to be at most this
  double tolerance;  ///< between the two bounds
  int max_steps;
};

struct GjkResult {
  /// How far the sets are apart along `normal`, without any pad against rounding; 0 if no direction
  /// that was tried separates them.
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();  ///< distance of the simplex from the
                                                           ///< origin
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, from the first set to the second
};

/// A step that does not bring the simplex nearer by this fraction has met the limit of rounding: it
/// stalls.
constexpr double kMinProgress = 1e-13;

/// Max number of stalls. Near contact, a step that stalls still turns the normal, because the
/// distance changes only by the square of the turn. Random bodies that nearly touch need at most 6
/// stalls for 1e-8 of their size.
constexpr int kMaxStalls = 10;

/// Every direction that the iteration tries bounds the distance from below, whatever becomes of the
/// iteration: the sets cannot be nearer than their supports along that direction are. The best
/// bound counts. Begins with the points of `simplex`; if it has none, with the direction
/// `first_to_second`. On return, `simplex` is the nearest one, reduced to the points that it needs.
template <class First, class Second>
GjkResult gjk(const First& first, const Placement& first_at, const Second& second,
              const Placement& second_at, const Eigen::Vector3d& first_to_second,
              const GjkGoal& goal, Simplex& simplex) {
  GjkResult result;
  Eigen::Vector3d nearest = -first_to_second;
  if (simplex.size() > 0) {
    const SimplexPoint found = simplex.nearest();
    simplex.keep(found);
    nearest = found.point;
    result.upper = nearest.norm();
  }
  Simplex best;  // the nearest simplex so far, if the current one is farther
  bool is_worse = false;
  int stalls = 0;
  // A simplex of four points surrounds the origin: the sets intersect, up to rounding.
  for (int step = 0; step < goal.max_steps && simplex.size() < 4; ++step) {
    const double length = nearest.norm();
    if (!(length > kShortest)) break;
    const Eigen::Vector3d normal = simplex.acrossEdges(nearest / -length, length);
    DifferencePoint next;
    next.first = first.farthest(first_at.toShape(normal));
    next.second = second.farthest(-second_at.toShape(normal));
    next.difference = first_at.toSearch(next.first) - second_at.toSearch(next.second);
    const double gap = -normal.dot(next.difference);
    if (gap > result.lower) {
      result.lower = gap;
      result.normal = normal;
    }
    if (result.lower >= goal.enough || result.upper - result.lower <= goal.tolerance) break;
    if (simplex.contains(next.difference)) break;
    simplex.add(next);
    const SimplexPoint found = simplex.nearestWithLast();
    nearest = found.point;
    const double now = nearest.norm();
    if (!(now < result.upper * (1 - kMinProgress)) && ++stalls > kMaxStalls) {
      simplex.removeLast();
      break;
    }
    if (!(now < result.upper) && !is_worse) {
      best = simplex;
      best.removeLast();
    }
    is_worse = !(now < result.upper);
    if (!is_worse) result.upper = now;
    simplex.keep(found);
    if (result.upper <= goal.too_near) break;
  }
  if (is_worse) simplex = best;
  return result;
}

}  // namespace link_bounds

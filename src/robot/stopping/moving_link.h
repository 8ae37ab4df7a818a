// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The box of a link while the joints before it move a little, independently of each other.
//
// All is in one frame, with axes where they are at the start. Let h(d) be the support of a set: the
// max of d . p over its points p. Let S be all places of the link while the joints after joint j
// move. Joint j turns S by an angle q from a to b about an axis n through o. A point p then has the
// coordinate m . o + d . (p - o) along a direction m, with d = Q(-q) m. So the support of the
// turned set is
//
//   m . o + max over q of g(Q(-q) m),   g(d) = h(d) - d . o.
//
// With w = b - a < pi, the directions at a and b are d0, d1, and c = (n . m) n is what they share.
// A direction between them is u d0 + v d1 - (u + v - 1) c, with u = sin(w - x) / sin w and
// v = sin x / sin w, x = q - a; u + v >= 1. Supports are sublinear, so
//
//   g(d) <= u g(d0) + v g(d1) + (u + v - 1) g(-c) = u A + v B - g(-c)
//
// with A = g(d0) + g(-c) and B = g(d1) + g(-c). The max over x of u A + v B is A, B, or the height
// of the sinusoid through both. The same holds with anything larger for g. For g(-c) that is |n .
// m| r, if S is inside a ball of radius r around a point at the height of o. For a single point of
// S all of it is exact. So each joint that turns needs supports of S along twice as many directions
// (more if w is large), and those of the link are computed at the end.
//
// If these are too many, a joint uses only the support of S along the direction d in the middle of
// its turn. A point p moves along d by (Q(-x) d - d) . (p - o) = f(x) + (Q(-x) d - d) . (p - c),
// where c is the centre of a ball of radius r around S, and f(x) is how the point c moves, a
// sinusoid. The other term is bounded for the ball: its points with d . (p - c) <= k = h(d) - d . c
// have, along a direction at an angle t from d, at most k cos t + sqrt(r^2 - k^2) sin t, and at
// most r. So a set that is small beside its distance from the axis is bounded nearly exactly.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// A joint and how it may move, in the frame of the box.
struct MovingJoint {
  enum class Kind {
    kTurn,   ///< about the axis
    kSlide,  ///< along the axis
    kFree    ///< a base, which drives along a path
  };

  Kind kind;
  Eigen::Vector3d origin;  ///< on the axis; for a base, the point whose path is known
  Eigen::Vector3d axis;    ///< unit; for a base the direction of its path
  Limits offsets{0, 0};    ///< range of motion from the present value [rad or m]; not for a base
  double distance = 0;     ///< length of the path of a base [m]
  double spread = 0;       ///< max angle of the path with its direction [rad]
  double turn = 0;         ///< max turn of a base about any axis [rad]
};

/// Contains the link in all poses that the joints allow, rounded outward and padded. `joints` are
/// sorted from the frame of the box to the link. Nothing if there is no box.
std::optional<Aabb> boxOfMoving(const BoundedLink& link, const Eigen::Affine3d& frame_from_link,
                                const std::vector<MovingJoint>& joints);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a point of a link can be from the straight way between two of its places.
//
// Let f(s), s from 0 to 1, be a coordinate of the point, and |f''| <= A. Then
//
//   f(s) <= (1-s) f(0) + s f(1) + A/8,
//
// because with A s(1-s)/2 <= A/8 instead of A/8, right side minus left side is 0 at the ends and
// concave. So the point stays in the box around its two places, each face moved outward by A/8.
// That holds for each point of the link. So the link stays in the box around its two boxes, each
// face moved outward by A/8. In each of n equal parts of the way, A is n^2 times smaller.
//
// A comes from the edges of tf. Between two samples tf2 interpolates a translation p linearly and a
// quaternion q by slerp, and moves a point y of the child to F(y) + p with F(y) = q y q*.
//
// 1. slerp is q(s) = (sin((1-s)T) q0 + sin(sT) q1) / sin T, where T is half the angle between both
//    rotations, at most pi/2. So q'' = -T^2 q, and E = |q'|^2 + T^2 |q|^2 is the same for all s.
//    Let l be the larger length of both quaternions and c the difference of the lengths. Then
//      |q| <= l: if both were of length l, q would be, too; and their dot product is not negative.
//      |q'| <= g = T l + (pi/2) c: at s = 0, E = T^2 (2 l0 l1 + (c / sin T)^2). Because |q| is at
//        least the smaller length m, 2 l0 l1 - |q|^2 <= 2 l m - m^2 <= l^2. With T / sin T <= pi/2,
//        |q'|^2 <= T^2 l^2 + (pi/2)^2 c^2.
// 2. F(y)' = q' y q* + q y q'*, and F(y)'' = 2 q' y q'* - 2 T^2 F(y). With T l <= g:
//      |F(y)| <= l^2 |y|,   |F(y)'| <= 2 l g |y|,   |F(y)''| <= 4 g^2 |y|.
//    For quaternions of length 1 these are 1, the angle and its square: a point on a circle.
// 3. A point with distance X from the origin of the child, speed V and acceleration A has in the
//    parent, with d = |p1 - p0|:
//      X <- l^2 X + max(|p0|, |p1|),  V <- 2 l g X + l^2 V + d,  A <- 4 g^2 X + 4 l g V + l^2 A.
//    That is the product rule for F(y(s)) + p(s). Apply it edge by edge up to the nearest common
//    ancestor of link and target: to the point of the link, and to the origin of the target.
// 4. In that frame, take the difference of both points: X, V and A add up. tf2 turns it by the
//    conjugates of the target's quaternions: step 3 without p, from the ancestor to the target.
// 5. The link itself is turned by the product of all quaternions, divided by its length. That is
//    the same as beginning with the point y / r, where r is the product of all |q|^2. From 1,
//    (|q|^2)'' = 2 |q'|^2 - 2 T^2 |q|^2 = 4 T^2 (l0 l1 - |q|^2) + 2 (T / sin T)^2 c^2, at most 15 l
//    c in size, and |(|q|^2)'| <= |l1^2 - l0^2| + 15 l c <= 17 l c. With e = 20 c / (smaller
//    length) for each edge, |(log 1/r)'| <= sum e and |(log 1/r)''| <= sum (e + e^2). In one of n
//    equal parts of the way, e of the first sum becomes e/n; e + e^2 becomes e/n^2 + (e/n)^2.
// 6. tf2 treats an angle that is nearly zero as zero, and then keeps the older quaternion until the
//    newer sample. The threshold depends on how tf2 was compiled: fused multiplications, as in
//    Debian's build for 64-bit ARM, change it. Where this may happen, let j be the sum of that
//    angle and (l^2 - m^2) / m^2. Then a point may be off by J more, with J <- l^2 (J + j X) for
//    each edge, starting with the sum of all j times |y / r|. Squares of lengths that differ by
//    more than 1e-5, which are no rounding errors, would make J too large. They are left out of j,
//    and the box must contain two motions: the one by tf2's formula as compiled here, and the one
//    by the tf2 library.
#pragma once

#include <vector>

#include "world/tf/tf2_pose.h"

namespace link_bounds {

/// Bounds of the motion of an edge from one sample to the next, or in a part of that time.
struct EdgeStep {
  double length2 = 1;            ///< l^2 in 2 above: the square of the larger length
  double min_length2 = 1;        ///< the square of the smaller length
  double turn = 0;               ///< g in 1 above [rad]
  double stretch = 0;            ///< e in 5 above
  double stretch2 = 0;           ///< the e of e + e^2 in 5 above, which bounds (|q|^2)'' / |q|^2
  double shift = 0;              ///< d in 3 above [m]
  double distance = 0;           ///< max(|p0|, |p1|) in 3 above [m]
  double jump = 0;               ///< j in 6 above
  bool is_jump_partial = false;  ///< `jump` lacks (l^2 - m^2) / m^2, see 6 above
  /// tf2 does not interpolate between the quaternions, because they differ only by rounding or in
  /// length. It keeps the older one until the newer sample.
  bool is_sudden = false;

  /// The motion in a part of the time, whose share is `part`.
  EdgeStep in(double part) const;
};

EdgeStep stepBetween(const Tf2Pose& older, const Tf2Pose& newer);

/// The edges from the link and from the target up to their nearest common ancestor.
struct PathSteps {
  std::vector<EdgeStep> from_link;
  std::vector<EdgeStep> from_target;
};

/// Max distance by which the points of a link leave the hull of their places at both ends.
struct Bulge {
  double smooth;    ///< in one of n equal parts of the time n^2 times smaller, but for rounding [m]
  double jump;      ///< J in 6 above, the same in any part of the time [m]
  double rounding;  ///< share of `smooth` that is the same in any part of the time [m]

  /// The bulge in any part of the time whose share is at most `part` [m].
  double in(double part) const {
    return (part > 0 ? part * part * (smooth - rounding) : 0) + rounding + jump;
  }
};

/// `radius`: max distance of the points from the origin of the link [m].
/// `distance`: max distance of the origins of link and target from each other, at both ends [m].
Bulge bulge(const PathSteps& path, double radius, double distance);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a point of a link can be from the straight way between two of its places.
//
// Let f(s), s from 0 to 1, be a coordinate of the point, and |f''| <= A. Then
//
//   f(s) <= (1-s) f(0) + s f(1) + A/8,
//
// because the difference of both sides is 0 or more at the ends if A/8 is replaced by A s(1-s)/2,
// and that difference is concave. So the point stays in the box around its two places, each face
// moved outward by A/8. That holds for each point of the link, so the link stays in the box around
// its two boxes, moved outward as much. In n equal parts of the way, A is n^2 times smaller.
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
//    That is the product rule for F(y(s)) + p(s). One edge after the other leads to the nearest
//    frame above both, from the link and, with a point at its origin, from the target.
// 4. There the difference of both counts: X, V and A add up. tf2 turns it by the conjugates of the
//    target's quaternions: step 3 without p, from the nearest frame above both to the target.
// 5. The link itself is turned by the product of all quaternions, divided by its length. That is
//    the same as beginning with the point y / r, where r is the product of all |q|^2. From 1,
//    (|q|^2)'' = 2 |q'|^2 - 2 T^2 |q|^2 = 4 T^2 (l0 l1 - |q|^2) + 2 (T / sin T)^2 c^2, at most 15 l
//    c in size, and |(|q|^2)'| <= |l1^2 - l0^2| + 15 l c <= 17 l c. With e = 20 c / (smaller
//    length) for each edge, |(log 1/r)'| <= sum e and |(log 1/r)''| <= sum (e + e^2). In the n-th
//    part of the way, e and e^2 become e/n and (e/n)^2, and the first e of that sum e/n^2.
// 6. tf2 takes an angle that is nearly zero for zero, and then keeps the older quaternion until the
//    newer sample. Where that begins depends on how tf2 was compiled: with fused multiplications,
//    as Debian's for 64-bit ARM, it is elsewhere. Where it may happen, let j be that angle and
//    (l^2 - m^2) / m^2 together. Then a point may be off by J more, with J <- l^2 (J + j X) for
//    each edge, beginning with the sum of all j times |y / r|. Squares of lengths that differ by
//    more than 1e-5, which are no rounding errors, would make J too large. They are left out of j,
//    and the box must hold both motions: by tf2's formula as it is compiled here, and by the
//    library.
#pragma once

#include <vector>

#include "world/tf/tf2_pose.h"

namespace link_bounds {

/// What happens to an edge from one sample to the next, or in a part of that time.
struct EdgeStep {
  double length2 = 1;            ///< l^2 in 2 above: the square of the larger length
  double min_length2 = 1;        ///< the square of the smaller length
  double turn = 0;               ///< g in 1 above [rad]
  double stretch = 0;            ///< e in 5 above
  double stretch2 = 0;           ///< of that, what bounds (|q|^2)'' / |q|^2
  double shift = 0;              ///< d in 3 above [m]
  double distance = 0;           ///< max(|p0|, |p1|) in 3 above [m]
  double jump = 0;               ///< j in 6 above
  bool is_jump_partial = false;  ///< j lacks the lengths
  /// tf2 does not interpolate between the rotations, which differ by rounding or in length alone:
  /// it keeps the older one until the newer sample.
  bool is_sudden = false;

  /// In one of 1 / `part` equal parts of the time.
  EdgeStep in(double part) const;
};

EdgeStep stepBetween(const Tf2Pose& older, const Tf2Pose& newer);

/// The edges from the link, and from the target, up to the nearest frame above both.
struct PathSteps {
  std::vector<EdgeStep> from_link;
  std::vector<EdgeStep> from_target;
};

/// How far the points of a link leave the hull of their places at both ends.
struct Bulge {
  double smooth;    ///< in n equal parts of the time it is n^2 times smaller, but for rounding [m]
  double jump;      ///< J in 6 above, in any part of the time [m]
  double rounding;  ///< of `smooth`, in any part of the time [m]

  /// In any part of the time that is no longer than this part of it.
  double in(double part) const {
    return (part > 0 ? part * part * (smooth - rounding) : 0) + rounding + jump;
  }
};

/// `radius`: their distance from the origin of the link [m], at most.
/// `distance`: that of the origin of the link from that of the target, at both ends [m], at most.
Bulge bulge(const PathSteps& path, double radius, double distance);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far two bodies can move towards each other while the joints between them move in a box around
// one pose.
//
// Let 0 .. n-1 be the joints of the path from the first body A to the second body B, with values in
// [c_j - w_j, c_j + w_j], and cut the path at one link: the joints before it count as moving A,
// those after it as moving B. So this link rests, and the axes of all joints begin where they are
// at c.
//
// First bound. Take B from c to any pose of the box one joint at a time, the joint nearest to the
// resting link first. While joint j turns, the joints between it and B are still at c, so a point
// of B is as far from axis j as it is at c: at most lever_j. It moves on a circle about this axis,
// over a chord of at most 2 sin(min(w_j, pi) / 2) lever_j. A prismatic joint moves it by w_j. The
// sum over the joints bounds how far any point of B moves, the same holds for A, and the distance
// of A and B shrinks by no more than both together.
//
// Second bound. Along a direction m, a point p of B has the coordinate m . p(d) for offsets d of
// its joints. Its Taylor series is m . p + sum d_j m . (a_j x (p - o_j)) + R. For fixed p the
// linear part is linear in d, so its min over all p of B is concave in d, and smallest at a corner
// of the box. A derivative by d_i and d_j, where j is the joint nearer to B, is at most the speed
// v_j that joint j gives to a point of B anywhere in the box. It is 1 for a prismatic joint, and
// otherwise the distance from axis j, so at most lever_j and what the joints between j and B move
// the point. It is 0 where i is prismatic. So |R| is at most half the sum of w_i w_j v_j over all i
// and j.
#pragma once

#include "robot/pairs/body_cloud.h"
#include "robot/pairs/joint_path.h"

namespace link_bounds {

/// A pair of bodies on the first and the second link of a path. Refers to its arguments.
class MotionBound {
 public:
  MotionBound(const JointPath& path, const BodyCloud& first, const BodyCloud& second);

  /// The members below are about this box. `placed` is the path at its centre, and must live until
  /// the next call.
  void set(const JointBox& box, const PlacedPath& placed);

  /// The distance of the bodies anywhere in the box is at least that at the centre less this [m].
  double motion() const { return motion_; }

  /// The variable that adds most to motion().
  std::size_t widestVariable() const;

  /// Anywhere in the box `first` and `second`, which are the bodies or parts of them, are at least
  /// this far apart along some direction [m]; negative if they may not be apart. `normal` is a unit
  /// vector from the first one to the second, in the frame of the first body.
  double gapAlong(const Eigen::Vector3d& normal, const BodyCloud& first,
                  const BodyCloud& second) const;

  /// Rounding of poses makes a distance too large by at most this [m].
  double rounding() const { return rounding_; }

 private:
  /// The joints that move one of the bodies, that nearest to the resting link first.
  struct Side {
    const BodyCloud* body;
    Eigen::Isometry3d from_body;  ///< to the frame of the first link, at the centre
    std::vector<std::size_t> joints;
    std::vector<double> moves;  ///< by joint: max motion of a point of the body [m]
    double own_lever = 0;       ///< lever of the joint next to the body, the same in all poses [m]
  };

  void measure(Side& side, std::size_t joint);
  double lever(const Side& side, std::size_t joint) const;
  void chooseCut();
  double farthestAlong(const Side& side, const BodyCloud& part,
                       const Eigen::Vector3d& direction) const;
  double remainder(const Side& side) const;

  const JointPath& path_;
  const PlacedPath* placed_ = nullptr;
  std::vector<double> half_widths_;  ///< one per joint
  Side first_;
  Side second_;
  double motion_ = 0;
  double rounding_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// An upper bound of how far a link extends along each axis of the root's frame, in all poses.
//
// Let S_i be the set of all places of the link's points in the frame before joint i, while joints
// i, i+1, ... of its chain take all their values, and h_i its support function (support_table.h).
// A point p of S_i+1 is moved by joint i to t + R Q(q) p, where t and R come from the URDF and Q(q)
// turns by q about the axis. Its dot product with d is t.d + p.e with e(q) = Q(-q) R^T d. So
//
//   h_i(d) = t.d + max over q of h_i+1(e(q)).
//
// The joints behind i do not depend on q, so this holds exactly, not only as a bound. Joints that
// share a variable are treated below. S_i is known by its table alone, from the link back to the
// root: no more than two dimensions, however many joints there are.
//
// - A prismatic joint moves by q along a = R axis: h_i(d) = t.d + max of q a.d + h_i+1(R^T d), and
//   the max is at an end of the range.
// - A revolute joint: e(q) = f + g(q) has a constant part f along the axis and a part g(q) that
//   turns. Cut the range into pieces. In the piece from q0 to q1 = q0 + D with D < pi
//     g(q) = A g(q0) + B g(q1),   A = sin(q1 - q) / sin D >= 0,   B = sin(q - q0) / sin D >= 0,
//   and A + B >= 1. So e(q) = A e(q0) + B e(q1) + (A + B - 1)(-f), and with c = h_i+1(-f)
//     h_i+1(e(q)) <= A (h_i+1(e(q0)) + c) + B (h_i+1(e(q1)) + c) - c.
//   The right side is a sinusoid plus a constant. Its largest value between q0 and q1 is at an end,
//   or is the amplitude sqrt(a^2 + b^2 - 2 a b cos D) / sin D, where a and b are the two brackets.
// - The link itself: its box in a pose whose rows are directions gives its support in those.
// - Joints that share a variable, because one mimics the other: the range of the variable is cut
//   into slices. In a slice they count as independent, which adds poses and takes none away. From
//   the first of them on, S_i is the union over all slices, and h_i the max.
//
// Rounding. Let r be an upper bound of the distance of any point of the link from any origin of its
// chain, and u = 2^-53. All directions of the recursion have a length of at most sqrt 3, up to
// rounding, because those of the grid have. Then e(q) is off by at most 50 u in length, and so
// h_i+1(e(q)) by 50 u r. The mean of four values, the sinusoid and the sum with t.d add less than
// 50 u r, because all of them are at most 2 sqrt 3 r in size; in doubles, a full turn lacks less
// than 3 u. The kinematics that place a link for a pose are off by less than 20 u r per joint.
// kRoundoffsPerJoint u r per joint is more than all of these.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "robot/pairs/joint_path.h"
#include "robot/reach/support_table.h"

namespace link_bounds {

/// Returns true to end a computation early. Several threads may call it.
using Stop = std::function<bool()>;

class ReachBound {
 public:
  /// `chain` is the path from the root to the link. `link` has a box in every pose, and no padding;
  /// `radius` is r above [m]. All arguments but `stop` must outlive this object.
  ReachBound(const JointPath& chain, const BoundedLink& link, double radius, int cells, Stop stop);

  /// To be called before box(): each support of the tables is rounded up to a multiple of the step
  /// [m], and one step is added, so that checkers that round otherwise can verify it. Joints that
  /// share a variable count as independent.
  void roundSupports(double step) { step_ = step; }

  std::size_t joints() const { return chain_.joints.size(); }
  /// Upper bounds of h_joint along the directions of the table. To be called after box(), for a
  /// chain whose joints count as independent; `joint` is not 0.
  const std::vector<double>& supportsAfter(std::size_t joint) const {
    return tables_[joint]->supports();
  }

  /// The box in the root's frame that the link never leaves, rounded outward; nothing if stopped.
  std::optional<Aabb> box();

  /// Values of the variables near a pose in which the link extends far along `direction`. Call it
  /// after box().
  std::vector<double> guess(const Eigen::Vector3d& direction) const;

 private:
  using Supports = std::optional<std::vector<double>>;
  using Directions = std::vector<Eigen::Vector3d>;
  using Table = std::shared_ptr<const SupportTable>;
  /// By variable: the slice of its range that is examined; nothing: the whole range.
  using Slices = std::vector<std::optional<Limits>>;

  Supports supports(std::size_t joint, const Directions& directions, const Slices& slices);
  Supports unionOfSlices(std::size_t joint, const Directions& directions, Slices slices);
  Supports supportsOfLink(const Directions& directions) const;
  Supports moved(const PathJoint& joint, const Limits& range, const SupportTable& child,
                 const Directions& directions) const;
  Table table(std::size_t joint, Slices slices);
  bool isShared(std::size_t variable) const { return step_ == 0 && chain_.isShared(variable); }
  Limits rangeOf(const PathJoint& joint, const Slices& slices) const;

  const JointPath& chain_;
  const BoundedLink& link_;
  double radius_;
  int cells_;
  Stop stop_;
  double step_ = 0;  ///< 0: supports are not rounded
  Directions grid_;
  std::vector<Table> tables_;  ///< one per joint, then that of the link; none with slices
};

}  // namespace link_bounds

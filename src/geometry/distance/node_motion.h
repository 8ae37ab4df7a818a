// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a bound of two nodes may be carried along its normal. The bound is n . v >= d for the vectors
// v between all their points, n unit. Let A be the body that rests, u = A'n, and M q + m the point
// q of the other body as A sees it (lease.cpp). Then u . A'v is n . v, and from one pair of poses
// to the next one it changes by u . ((M1 - M0) q + m1 - m0), or its negative where v points from
// the other body to A. Over the box of the node of q this is smallest at a corner. |v| is at least
// u . A'v. The slack of lease.cpp covers poses that are not quite rigid. A normal is kept in
// floats, so u is wrong by less than 2^-23, and the bound by that fraction of a point's motion,
// which is at most the growth of Approach::moved, up to the rounding of that difference. Rounding
// here is that of a few products with the coordinates of the shape, which the rounding of the
// search bounds (placed_body.cpp).
#pragma once

#include "geometry/distance/tree_front.h"
#include "geometry/distance/tree_search.h"
#include "geometry/distance/triangle_tree.h"

namespace link_bounds {

/// How nodes have moved since the last call with the memory. `pair.motion.latest` must be known.
class NodeMotion {
 public:
  explicit NodeMotion(const ShapePair& pair)
      : is_second_(&resting(*pair.first_rigid, *pair.second_rigid) == &*pair.first_rigid),
        mover_(is_second_ ? pair.second : pair.first) {
    const RelativeMotion& motion = *pair.motion.latest;
    const Eigen::Affine3d& from_shape = mover_.shape.link_from_shape;
    turned_ = motion.turned * from_shape.linear();
    shifted_ = motion.turned * from_shape.translation() + motion.shifted;
    slack_ =
        motion.slack + pair.boxRounding() + 0x1p-22 * (pair.motion.moved - pair.motion.moved_then);
  }

  /// How much smaller the bound of two nodes is now [m]; negative: larger.
  double approach(const FrontPair& nodes) const {
    if (!mover_.triangles) return std::numeric_limits<double>::infinity();
    const TreeNode& node = mover_.triangles->nodes[is_second_ ? nodes.second : nodes.first];
    if (!nodes.is_along) {
      double length = (turned_ * node.center().cast<double>() + shifted_).norm();
      for (int k = 0; k < 3; ++k)
        length += (turned_ * node.edge(k).cast<double>()).norm();
      return length + slack_;
    }
    const Eigen::Vector3d nearer = is_second_ ? -nodes.direction() : nodes.direction();
    const Eigen::Vector3d in_shape = turned_.transpose() * nearer;
    return nearer.dot(shifted_) + node.farthest(in_shape) + slack_;
  }

 private:
  bool is_second_;  ///< whether the second body moves
  const BodyShape& mover_;
  Eigen::Matrix3d turned_;  ///< a point p of the shape moves by turned_ p + shifted_
  Eigen::Vector3d shifted_;
  double slack_;
};

}  // namespace link_bounds

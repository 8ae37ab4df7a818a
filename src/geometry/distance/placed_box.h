// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of tree nodes in the coordinates of a search, and how far two of them are apart.
#pragma once

#include "geometry/distance/triangle_tree.h"

namespace link_bounds {

/// Where the boxes of a tree are during a search.
struct BoxPlacement {
  explicit BoxPlacement(const Placement& its_at)
      : at(its_at), linear(at.linear.cast<float>()), largest(linear.cwiseAbs().maxCoeff()) {}

  const Placement& at;
  Eigen::Matrix3f linear;
  float largest;  ///< max |entry| of `linear`

  /// The pad of the width of a node's box, as derived below [m].
  double padOf(const TreeNode& node) const {
    return 0x1p-19f * largest *
           ((node.x.abs() + node.y.abs() + node.z.abs()) * TreeNode::edgesOnly()).sum();
  }
};

/// The box of a node in the coordinates of a search. Its edges are floats there, so a width that is
/// computed is padded. Let v = 2^-24, L the axes of the placement, l its largest |entry|, E the sum
/// of all |coordinates| of the node's edges. A coordinate of L e is wrong by 4 v l |e|_1 for the
/// rounding of L, a product and two sums; its product with a unit vector n by as much again, and
/// the sums over the edges by 3 v: together 11 v l E |n|_1, which is less than 20 v l E. The pad is
/// 32 v l E.
class PlacedBox {
 public:
  PlacedBox(const TreeNode& node, const BoxPlacement& its)
      : center(its.at.toSearch(node.center().cast<double>())),
        x_(row(node, its.linear, 0)),
        y_(row(node, its.linear, 1)),
        z_(row(node, its.linear, 2)),
        pad_(its.padOf(node)),
        inverse_((x_ * x_ + y_ * y_ + z_ * z_).max(kShortestSquare).inverse()) {}

  /// Approximately the nearest point of the box to `point`, if the edges are orthogonal, as in a
  /// rigid pose.
  Eigen::Vector3d near(const Eigen::Vector3d& point) const {
    const Eigen::Vector3f from = (point - center).cast<float>();
    const Eigen::Array4f along = x_ * from.x() + y_ * from.y() + z_ * from.z();
    const Eigen::Array4f parts = (along * inverse_).max(-1.0f).min(1.0f);
    const Eigen::Vector3f offset((parts * x_).sum(), (parts * y_).sum(), (parts * z_).sum());
    return center + offset.cast<double>();
  }

  /// Upper bound of half the width along a unit direction [m].
  double extent(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3f d = direction.cast<float>();
    return (x_ * d.x() + y_ * d.y() + z_ * d.z()).abs().sum() + pad_;
  }

  const Eigen::Vector3d center;

 private:
  static constexpr float kShortestSquare = 1e-30f;  ///< for edges that a flat pose shrinks to 0

  static Eigen::Array4f row(const TreeNode& node, const Eigen::Matrix3f& linear, int i) {
    return (node.x * linear(i, 0) + node.y * linear(i, 1) + node.z * linear(i, 2)) *
           TreeNode::edgesOnly();
  }

  Eigen::Array4f x_, y_, z_;  ///< coordinates of the three edges
  double pad_;
  Eigen::Array4f inverse_;  ///< of their squared lengths
};

/// What is known of the distance of two sets.
struct Separation {
  double lower;            ///< proven [m]
  double near;             ///< about the distance; says where to look first
  Eigen::Vector3d normal;  ///< unit; a direction in which the sets may be separate
  bool is_along = false;   ///< `lower` is proven along `normal`

  /// Takes the bound along a direction if it is larger.
  void raise(double lower_along, const Eigen::Vector3d& along) {
    if (!(lower_along > lower)) return;
    lower = lower_along;
    normal = along;
    is_along = true;
  }
};

/// Raises `known.lower` until it is at least `far_enough`, or until the boxes are proven to be
/// nearer, or for a few steps. `rounding` is the max error of a computed bound. Projects a point
/// from box to box: faster than GJK, and it need not converge.
void separate(const PlacedBox& first, const PlacedBox& second, double far_enough, double rounding,
              Separation& known);

}  // namespace link_bounds

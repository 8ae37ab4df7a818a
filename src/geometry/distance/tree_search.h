// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Branch and bound over the trees of two shapes.
#pragma once

#include <cmath>
#include <optional>

#include "geometry/distance/leaf.h"
#include "geometry/distance/placed_body.h"
#include "geometry/distance/placed_box.h"
#include "geometry/distance/tree_front.h"
#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {

/// The two nearest points so far, in the coordinates of the search.
struct Witness {
  Eigen::Vector3d on_first = Eigen::Vector3d::Zero();
  Eigen::Vector3d on_second = Eigen::Vector3d::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

/// The indices of two triangles; 0 for a shape without triangles.
struct TrianglePair {
  std::uint32_t first;
  std::uint32_t second;
};

/// What a search leaves for the next one of the same trees.
struct TreeMemory {
  std::optional<TrianglePair> nearest;
  Front front;
};

/// Two nodes that a search has not decided yet.
struct NodePair {
  std::uint32_t first;
  std::uint32_t second;
  Separation separation;
  std::uint32_t hull_count = kSmallNode;  ///< nodes of more triangles are not compared by hulls
};

/// The leaves of a tree that a search has placed last.
class PlacedLeaves {
 public:
  /// To be called before each search.
  void clear() { nodes_.fill(kNone); }

  const PlacedLeaf& at(const TriangleTree& tree, std::uint32_t node, const Placement& placement) {
    const std::size_t slot = node % kSlots;
    if (nodes_[slot] != node) leaves_[slot].place(tree, node, placement);
    nodes_[slot] = node;
    return leaves_[slot];
  }

 private:
  static constexpr std::size_t kSlots = 32;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::array<std::uint32_t, kSlots> nodes_;
  std::array<PlacedLeaf, kSlots> leaves_;
};

/// Buffers that a search needs only until it ends. Reusing them for the next search saves
/// allocations.
struct TreeScratch {
  std::vector<NodePair> open;
  std::vector<NodePair> near;  ///< pairs of the last front whose bound is no longer large enough
  PlacedLeaves first_leaves;
  PlacedLeaves second_leaves;

  void clear() {
    open.clear();
    near.clear();
    first_leaves.clear();
    second_leaves.clear();
  }
};

/// How much nearer two bodies may have come [m]
struct Approach {
  double moved;                                 ///< since the memory began
  double moved_then;                            ///< until the last call with the memory
  const std::optional<RelativeMotion>& latest;  ///< since that call, if it is known
};

/// Two shapes whose distance is searched. A shape without triangles is a leaf by itself. If a shape
/// hasCore(), only its core is searched: GJK takes few steps between points and edges, but many on
/// round surfaces.
struct ShapePair {
  const BodyShape& first;
  const BodyShape& second;
  Placement first_at;
  Placement second_at;
  PlacedBall first_ball;
  PlacedBall second_ball;
  double rounding;  ///< max error of a computed lower bound [m]
  const Approach& motion;
  const std::optional<RigidBody>& first_rigid;
  const std::optional<RigidBody>& second_rigid;

  bool isFollowed() const { return first_rigid && second_rigid; }

  ShapeHull firstHull() const { return {first, first_ball.outside > 0}; }
  ShapeHull secondHull() const { return {second, second_ball.outside > 0}; }

  /// Max difference between the distance of the cores and that of the shapes [m].
  double balls() const { return first_ball.outside + second_ball.outside; }

  /// balls() plus the error of a computed bound [m].
  double pad() const { return rounding + balls(); }

  /// Given a point of each core, takes the points of the two shapes on the line between them as the
  /// witness if these are nearer. Returns true if they are.
  bool improve(Witness& witness, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    const Eigen::Vector3d between = b - a;
    const double squared = between.squaredNorm();
    const double inside = first_ball.inside + second_ball.inside;
    const double enough = witness.distance + inside;
    if (!(squared < enough * enough)) return false;
    const double apart = std::sqrt(squared);
    if (!(inside > 0) || !(apart > 0)) {
      witness = {a, b, apart};
      return true;
    }
    const double from_a = std::min(first_ball.inside, apart);
    const double from_b = std::min(second_ball.inside, apart - from_a);
    witness.on_first = a + from_a / apart * between;
    witness.on_second = b - from_b / apart * between;
    witness.distance = (witness.on_second - witness.on_first).norm();
    return true;
  }

  /// `rounding` plus what tiny floats in TreeNode::extent() lose [m].
  double boxRounding() const {
    return rounding + 1e-43 * (1 + magnitudeOf(first) + magnitudeOf(second));
  }

 private:
  static double magnitudeOf(const BodyShape& shape) {
    return shape.triangles ? shape.triangles->magnitude : 0;
  }
};

/// Where the hulls of both shapes are nearest, as GJK found it.
struct NearestOfHulls {
  double lower;  ///< proven
  Eigen::Vector3d normal;
  Eigen::Vector3d on_first;
  Eigen::Vector3d on_second;
};

/// Improves `witness`, which may be of other shapes, and returns a lower bound of the distance of
/// these two that is at least hulls.lower. Ends when the bound is at least the limit or at least
/// witness.distance - accuracy. `memory` says where to look first. Its bounds hold after they are
/// reduced by the growth of pair.motion.moved since.
double searchTrees(const ShapePair& pair, const NearestOfHulls& hulls, TreeMemory& memory,
                   const DistanceGoal& goal, std::size_t& steps_left, Witness& witness,
                   TreeScratch& scratch);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A pair of nodes is dropped as soon as its boxes are proven to be far enough apart. Otherwise the
// larger node is replaced by its children, and the nearest pair comes first.
#include "geometry/distance/tree_search.h"

#include <algorithm>

#include "geometry/distance/gjk.h"
#include "geometry/distance/triangle_tree.h"

namespace link_bounds {
namespace {

constexpr int kBoxSteps = 8;     ///< then the pair counts as near
constexpr int kLeafSteps = 100;  ///< of shapes that are curved

/// Half of the accuracy is left to what follows.
constexpr double kLeafTolerance = 0.25;

struct NodePair {
  std::uint32_t first;
  std::uint32_t second;
  double lower;            ///< proven
  Eigen::Vector3d normal;  ///< the direction that proves it
};

bool isLeaf(const BodyShape& shape, std::uint32_t node) {
  return !shape.triangles || shape.triangles->nodes[node].isLeaf();
}

double radius(const BodyShape& shape, std::uint32_t node) {
  double result = 0;
  for (const Eigen::Vector3f& edge : shape.triangles->nodes[node].edges)
    result = std::max(result, static_cast<double>(edge.squaredNorm()));
  return result;
}

/// Calls `use` with the convex set that stands for a node.
template <class Use>
auto withNode(const BodyShape& shape, std::uint32_t node, const Use& use) {
  return shape.triangles ? use(shape.triangles->nodes[node].box()) : use(ShapeHull{shape.shape});
}

class Search {
 public:
  Search(const ShapePair& pair, double hull_lower, const DistanceGoal& goal,
         std::size_t& steps_left, Witness& witness)
      : pair_(pair),
        hull_lower_(hull_lower),
        goal_(goal),
        steps_left_(steps_left),
        witness_(witness) {}

  SearchResult run(const Eigen::Vector3d& normal, const LeafPair& begin_with) {
    if (begin_with.first || begin_with.second)
      compareLeaves({begin_with.first, begin_with.second, hull_lower_, normal}, false);
    open_.reserve(64);
    open_.push_back({0, 0, hull_lower_, normal});
    while (!open_.empty()) {
      const NodePair pair = open_.back();
      open_.pop_back();
      if (pair.lower >= farEnough() || steps_left_ == 0) {
        lower_ = std::min(lower_, pair.lower);
      } else if (isLeaf(pair_.first, pair.first) && isLeaf(pair_.second, pair.second)) {
        compareLeaves(pair, true);
      } else {
        --steps_left_;
        divide(pair);
      }
    }
    return {lower_, nearest_};
  }

 private:
  /// A pair that is proven to be so far apart cannot change the result.
  double farEnough() const { return std::min(goal_.limit, witness_.distance - goal_.accuracy); }

  bool dividesFirst(const NodePair& pair) const {
    if (isLeaf(pair_.first, pair.first)) return false;
    if (isLeaf(pair_.second, pair.second)) return true;
    return radius(pair_.first, pair.first) >= radius(pair_.second, pair.second);
  }

  void divide(const NodePair& pair) {
    NodePair left = pair, right = pair;
    if (dividesFirst(pair)) {
      left.first = pair_.first.triangles->nodes[pair.first].first;
      right.first = left.first + 1;
    } else {
      left.second = pair_.second.triangles->nodes[pair.second].first;
      right.second = left.second + 1;
    }
    bound(left);
    bound(right);
    const bool is_left_nearer = left.lower < right.lower;
    open_.push_back(is_left_nearer ? right : left);
    open_.push_back(is_left_nearer ? left : right);
  }

  /// Raises the pair's lower bound as far as it takes to drop it, or until that is hopeless.
  void bound(NodePair& pair) {
    const double far_enough = farEnough();
    const GjkGoal gjk_goal{far_enough + pair_.rounding, far_enough, 0, kBoxSteps};
    withNode(pair_.first, pair.first, [&](const auto& first) {
      withNode(pair_.second, pair.second, [&](const auto& second) {
        Simplex simplex;
        raise(pair,
              gjk(first, pair_.first_at, second, pair_.second_at, pair.normal, gjk_goal, simplex));
      });
    });
  }

  void raise(NodePair& pair, const GjkResult& result) const {
    const double lower = result.lower - pair_.rounding;
    if (!(lower > pair.lower)) return;
    pair.lower = lower;
    pair.normal = result.normal;
  }

  /// `counts`: these leaves are a part of the search, not only a first guess.
  void compareLeaves(const NodePair& pair, bool counts) {
    const TriangleTree* first = pair_.first.triangles.get();
    const TriangleTree* second = pair_.second.triangles.get();
    if (first && second && first->solid == Solid::kNone && second->solid == Solid::kNone) {
      compareTriangles(pair, counts);
      return;
    }
    forEachSet(pair_.first, pair.first, [&](const auto& a) {
      forEachSet(pair_.second, pair.second,
                 [&](const auto& b) { compareSets(pair, a, b, counts); });
    });
  }

  template <class Use>
  static void forEachSet(const BodyShape& shape, std::uint32_t leaf, const Use& use) {
    if (!shape.triangles) {
      use(ShapeHull{shape.shape});
      return;
    }
    const TriangleTree& tree = *shape.triangles;
    const TreeNode& node = tree.nodes[leaf];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      use(SweptTriangle{tree.corners(i), tree.solid, tree.size});
  }

  template <class First, class Second>
  void compareSets(const NodePair& pair, const First& first, const Second& second, bool counts) {
    Simplex simplex;
    const GjkGoal gjk_goal{farEnough() + pair_.rounding, 0, kLeafTolerance * goal_.accuracy,
                           kLeafSteps};
    NodePair sets = pair;
    raise(sets,
          gjk(first, pair_.first_at, second, pair_.second_at, pair.normal, gjk_goal, simplex));
    if (simplex.size() > 0) {
      offer(pair, pair_.first_at.toSearch(simplex.first()),
            pair_.second_at.toSearch(simplex.second()));
    }
    if (counts) lower_ = std::min(lower_, sets.lower);
  }

  static std::size_t place(const BodyShape& shape, const Placement& at, std::uint32_t leaf,
                           std::array<Triangle, kTrianglesPerLeaf>& triangles) {
    const TreeNode& node = shape.triangles->nodes[leaf];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const Triangle corners = shape.triangles->corners(node.first + i);
      for (std::size_t k = 0; k < 3; ++k)
        triangles[i][k] = at.toSearch(corners[k]);
    }
    return node.count;
  }

  /// How far b is from a along `normal`.
  static double gap(const Triangle& a, const Triangle& b, const Eigen::Vector3d& normal) {
    const double a_max = std::max({normal.dot(a[0]), normal.dot(a[1]), normal.dot(a[2])});
    const double b_min = std::min({normal.dot(b[0]), normal.dot(b[1]), normal.dot(b[2])});
    return b_min - a_max;
  }

  void compareTriangles(const NodePair& pair, bool counts) {
    std::array<Triangle, kTrianglesPerLeaf> first, second;
    const std::size_t n = place(pair_.first, pair_.first_at, pair.first, first);
    const std::size_t m = place(pair_.second, pair_.second_at, pair.second, second);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < m; ++j) {
        double lower = std::max(pair.lower, gap(first[i], second[j], pair.normal) - pair_.rounding);
        if (!(lower >= farEnough())) lower = std::max(lower, compare(pair, first[i], second[j]));
        if (counts) lower_ = std::min(lower_, lower);
      }
    }
  }

  /// Returns the proven distance of the two triangles.
  double compare(const NodePair& pair, const Triangle& first, const Triangle& second) {
    const PointPair nearest = nearestPoints(first, second);
    offer(pair, nearest.on_first, nearest.on_second);
    const Eigen::Vector3d between = nearest.on_second - nearest.on_first;
    const double length = between.norm();
    if (!(length > kShortest)) return 0;
    return gap(first, second, between / length) - pair_.rounding;
  }

  void offer(const NodePair& pair, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double distance = (b - a).norm();
    if (!(distance < witness_.distance)) return;
    witness_ = {a, b, distance};
    nearest_ = {pair.first, pair.second};
  }

  const ShapePair& pair_;
  double hull_lower_;
  const DistanceGoal& goal_;
  std::size_t& steps_left_;
  Witness& witness_;
  double lower_ = std::numeric_limits<double>::infinity();  ///< of all pairs that are dropped
  LeafPair nearest_;
  std::vector<NodePair> open_;
};

}  // namespace

SearchResult searchTrees(const ShapePair& pair, double hull_lower, const Eigen::Vector3d& normal,
                         const LeafPair& begin_with, const DistanceGoal& goal,
                         std::size_t& steps_left, Witness& witness) {
  return Search(pair, hull_lower, goal, steps_left, witness).run(normal, begin_with);
}

}  // namespace link_bounds

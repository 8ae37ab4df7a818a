// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A pair of nodes is dropped as soon as its boxes are proven to be far enough apart. Otherwise the
// larger node is replaced by its children, and the nearest pair comes first.
#include "geometry/distance/tree_search.h"

#include <algorithm>

#include "geometry/distance/gjk.h"
#include "geometry/distance/leaf.h"
#include "geometry/distance/node_motion.h"
#include "geometry/distance/placed_box.h"
#include "geometry/distance/triangle_tree.h"

namespace link_bounds {
namespace {

constexpr int kNodeSteps = 8;  ///< then the pair counts as near

constexpr int kLeafSteps = 100;  ///< only curved shapes need many

/// After so many pairs of a front whose bound no longer holds, goOn() judges the front by the pairs
/// seen so far. This takes 10 % less time for meshes if all poses are new, and the same in coherent
/// motion.
constexpr std::size_t kSample = 24;

/// If hulls do not separate two nodes, the next hulls are of nodes with so many times fewer
/// triangles: smaller parts of a curved surface are flatter.
constexpr std::uint32_t kNextHulls = 4;

/// The share of the accuracy that GJK between leaves uses.
constexpr double kLeafTolerance = 0.25;

bool isLeaf(const BodyShape& shape, std::uint32_t node) {
  return !shape.triangles || shape.triangles->nodes[node].isLeaf();
}

float squaredRadius(const BodyShape& shape, std::uint32_t node) {
  return shape.triangles->nodes[node].squaredRadius();
}

/// Calls `use` with the convex set that stands for a node.
template <class Use>
auto withNode(const BodyShape& shape, std::uint32_t node, const Use& use) {
  return shape.triangles ? use(shape.triangles->nodes[node].box()) : use(ShapeHull{shape});
}

class NodeSearch {
 public:
  NodeSearch(const ShapePair& pair, const NearestOfHulls& hulls, const DistanceGoal& goal,
             std::size_t& steps_left, Witness& witness, TreeMemory& memory, TreeScratch& scratch)
      : pair_(pair),
        hulls_(hulls),
        goal_(goal),
        steps_left_(steps_left),
        witness_(witness),
        memory_(memory),
        front_(memory.front.pairs()),
        scratch_(scratch),
        first_boxes_(pair.first_at),
        second_boxes_(pair.second_at),
        box_pad_(pair.boxRounding() + pair.balls()) {
    scratch_.clear();
  }

  double run() {
    const bool is_first = !memory_.nearest;
    if (!is_first) guess(*memory_.nearest);
    // The first search does not know a near witness yet and divides too much, so its front is not
    // kept.
    keeps_front_ = pair_.isFollowed() && !is_first;
    if (goOn()) {
      memory_.front.keep();
    } else {
      if (hulls_.lower < farEnough()) guessByHulls();
      scratch_.open.push_back({0, 0, {hulls_.lower, 0, hulls_.normal}});
      empty();
      memory_.front.begin();
    }
    return lower_;
  }

 private:
  /// A pair that is proven to be so far apart cannot change the result.
  double farEnough() const { return goal_.enough(witness_.distance); }

  /// Compares pairs of nodes until none is open.
  void empty() {
    while (!scratch_.open.empty()) {
      const NodePair pair = scratch_.open.back();
      scratch_.open.pop_back();
      if (pair.separation.lower >= farEnough() || steps_left_ == 0) {
        drop(pair);
      } else if (areLeaves(pair)) {
        compareLeaves(pair, true);
      } else {
        --steps_left_;
        divide(pair);
      }
    }
  }

  /// Begins with the last front: most of its pairs are still proven to be far enough apart, and
  /// only the others are searched. Drops the front and returns false if more than three quarters of
  /// the pairs no longer hold, because the poses have changed too much since.
  bool goOn() {
    if (front_.empty()) return false;
    std::optional<NodeMotion> motion;
    const double far_enough = farEnough();
    auto held = front_.begin();
    for (FrontPair& known : front_) {
      if (const auto lower = stillApart(known, far_enough, motion)) {
        lower_ = std::min(lower_, *lower);
        *held++ = known;
      } else if (scratch_.near.size() >= kSample && isOfAnotherTime(held - front_.begin())) {
        return giveUp();
      }
    }
    if (isOfAnotherTime(held - front_.begin())) return giveUp();
    front_.erase(held, front_.end());
    for (NodePair& pair : scratch_.near) {
      if (steps_left_ > 0) {
        --steps_left_;
        lookAgain(pair);
      }
      push(pair);
      empty();
    }
    return true;
  }

  /// Tries to prove that two nodes of the last front are still `far_enough` apart: by the motion of
  /// the bodies since, by the motion of the nodes, or along the direction that decided last time.
  /// Returns the bound. If nothing proves it, adds the pair to the near ones.
  std::optional<double> stillApart(FrontPair& known, double far_enough,
                                   std::optional<NodeMotion>& motion) {
    const double by_bodies = std::max(hulls_.lower, known.bound.at(pair_.motion.moved));
    if (by_bodies >= far_enough) return by_bodies;
    if (!motion) motion.emplace(pair_);
    const double by_nodes = known.bound.at(pair_.motion.moved_then) - motion->approach(known);
    if (by_nodes >= far_enough) {
      known.bound = {by_nodes, pair_.motion.moved};
      return by_nodes;
    }
    NodePair pair{known.first, known.second, {hulls_.lower, 0, hulls_.normal}};
    const Eigen::Matrix3d& axes = resting(*pair_.first_rigid, *pair_.second_rigid).axes;
    pair.separation.normal = (axes * known.direction()).normalized();
    if (!haveTriangles() || !areLeaves(pair)) {  // two leaves are bounded by their triangles
      pair.separation.raise(lowerAlong(pair, pair.separation.normal), pair.separation.normal);
    }
    if (pair.separation.lower >= far_enough) {
      known = dropped(pair);
      return pair.separation.lower;
    }
    scratch_.near.push_back(pair);
    return std::nullopt;
  }

  /// `held` is how many of the pairs looked at still hold. True if that is less than a quarter.
  bool isOfAnotherTime(std::ptrdiff_t held) const {
    return scratch_.near.size() > 3 * static_cast<std::size_t>(held);
  }

  bool giveUp() {
    lower_ = std::numeric_limits<double>::infinity();
    front_.clear();
    return false;
  }

  void lookAgain(NodePair& pair) {
    if (areLeaves(pair) || pair.separation.lower >= farEnough()) return;
    if (!pair_.first.triangles || !pair_.second.triangles) {
      boundHull(pair);
      return;
    }
    boundSmallNodes(pair);
    if (pair.hull_count < kSmallNode) return;
    boundBoxes(pair, boxOf(pair_.first, first_boxes_, pair.first),
               boxOf(pair_.second, second_boxes_, pair.second));
  }

  /// How far the boxes of two nodes are proven to be apart along a unit direction.
  double lowerAlong(const NodePair& pair, const Eigen::Vector3d& normal) const {
    return -support(pair_.first, pair_.first_at, pair.first, normal) -
           support(pair_.second, pair_.second_at, pair.second, -normal) - box_pad_;
  }

  /// The support of a node's convex set along a direction, from the origin of the search.
  static double support(const BodyShape& shape, const Placement& at, std::uint32_t node,
                        const Eigen::Vector3d& direction) {
    const Eigen::Vector3d d = at.toShape(direction);
    const double origin = at.translation.dot(direction);
    if (!shape.triangles) return origin + ShapeHull{shape}.farthest(d).dot(d);
    return origin + shape.triangles->nodes[node].farthest(d);
  }

  /// Gives up a pair that cannot change the result, or that no steps are left for.
  void drop(const NodePair& pair) {
    lower_ = std::min(lower_, pair.separation.lower);
    if (keeps_front_) front_.push_back(dropped(pair));
  }

  FrontPair dropped(const NodePair& pair) const {
    const RigidBody& rests = resting(*pair_.first_rigid, *pair_.second_rigid);
    const Eigen::Vector3d normal = rests.axes.transpose() * pair.separation.normal;
    return {pair.first,
            pair.second & FrontPair::kMaxNode,
            pair.separation.is_along,
            {static_cast<float>(normal.x()), static_cast<float>(normal.y()),
             static_cast<float>(normal.z())},
            {pair.separation.lower, pair_.motion.moved}};
  }

  void guess(const TrianglePair& triangles) {
    if (!haveTriangles()) {
      withSet(pair_.first, triangles.first, [&](const auto& a) {
        withSet(pair_.second, triangles.second, [&](const auto& b) {
          compareSets(triangles, {0, 0, hulls_.normal}, a, b);
        });
      });
      return;
    }
    const PointPair nearest =
        nearestPoints(placed(*pair_.first.triangles, triangles.first, pair_.first_at),
                      placed(*pair_.second.triangles, triangles.second, pair_.second_at));
    offer(triangles, nearest.on_first, nearest.on_second);
  }

  void guessByHulls() {
    const std::uint32_t first = leafNear(pair_.first, first_boxes_, hulls_.on_first);
    const std::uint32_t second = leafNear(pair_.second, second_boxes_, hulls_.on_second);
    compareLeaves({first, second, {hulls_.lower, 0, hulls_.normal}}, false);
  }

  static PlacedBox boxOf(const BodyShape& shape, const BoxPlacement& at, std::uint32_t node) {
    return PlacedBox(shape.triangles->nodes[node], at);
  }

  /// Descends to the child that is nearer, without backtracking.
  static std::uint32_t leafNear(const BodyShape& shape, const BoxPlacement& at,
                                const Eigen::Vector3d& point) {
    std::uint32_t node = 0;
    while (!isLeaf(shape, node)) {
      const std::uint32_t left = shape.triangles->nodes[node].child;
      const auto squaredDistance = [&](std::uint32_t child) {
        return (boxOf(shape, at, child).near(point) - point).squaredNorm();
      };
      node = squaredDistance(left) <= squaredDistance(left + 1) ? left : left + 1;
    }
    return node;
  }

  bool areLeaves(const NodePair& pair) const {
    return isLeaf(pair_.first, pair.first) && isLeaf(pair_.second, pair.second);
  }

  bool dividesFirst(const NodePair& pair) const {
    if (isLeaf(pair_.first, pair.first)) return false;
    if (isLeaf(pair_.second, pair.second)) return true;
    return squaredRadius(pair_.first, pair.first) >= squaredRadius(pair_.second, pair.second);
  }

  void divide(const NodePair& pair) {
    const bool divides_first = dividesFirst(pair);
    std::array<NodePair, 2> children{pair, pair};
    for (std::uint32_t i = 0; i < 2; ++i) {
      if (divides_first) {
        children[i].first = pair_.first.triangles->nodes[pair.first].child + i;
      } else {
        children[i].second = pair_.second.triangles->nodes[pair.second].child + i;
      }
    }
    if (pair_.first.triangles && pair_.second.triangles) {
      boundBoxes(children, divides_first);
    } else {
      boundHull(children[0]);
      boundHull(children[1]);
    }
    const std::size_t nearer = children[0].separation.near < children[1].separation.near ? 0 : 1;
    push(children[1 - nearer]);
    push(children[nearer]);
  }

  /// The children differ in one node and have the other one in common.
  void boundBoxes(std::array<NodePair, 2>& children, bool first_differs) {
    const PlacedBox a = boxOf(pair_.first, first_boxes_, children[0].first);
    const PlacedBox b = boxOf(pair_.second, second_boxes_, children[0].second);
    boundBoxes(children[0], a, b);
    if (first_differs) {
      boundBoxes(children[1], boxOf(pair_.first, first_boxes_, children[1].first), b);
    } else {
      boundBoxes(children[1], a, boxOf(pair_.second, second_boxes_, children[1].second));
    }
  }

  void push(const NodePair& pair) {
    if (pair.separation.lower >= farEnough()) {
      drop(pair);
    } else {
      scratch_.open.push_back(pair);
    }
  }

  void boundBoxes(NodePair& pair, const PlacedBox& first, const PlacedBox& second) const {
    separate(first, second, farEnough(), box_pad_, pair.separation);
    if (!(pair.separation.lower >= farEnough())) boundSmallNodes(pair);
  }

  /// Compares the hulls of small nodes. If they do not decide, hulls are compared again for much
  /// smaller nodes on the way down. The facing surfaces of small nodes are nearly convex, where a
  /// box leaves more room than the accuracy.
  void boundSmallNodes(NodePair& pair) const {
    const TreeNode& first = pair_.first.triangles->nodes[pair.first];
    const TreeNode& second = pair_.second.triangles->nodes[pair.second];
    const std::uint32_t count = std::max(first.count, second.count);
    if (count > pair.hull_count || count <= kTrianglesPerLeaf) return;
    pair.hull_count = count / kNextHulls;
    boundBy(NodeHull{*pair_.first.triangles, first}, NodeHull{*pair_.second.triangles, second},
            pair_.pad() + hullPad(pair_.first, first_boxes_) + hullPad(pair_.second, second_boxes_),
            pair.separation);
  }

  /// Max error due to kHullPad [m]. A pose stretches no vector by more than three times its largest
  /// entry.
  static double hullPad(const BodyShape& shape, const BoxPlacement& at) {
    return 4 * kHullPad * shape.triangles->magnitude * at.largest;
  }

  void boundHull(NodePair& pair) const {
    withNode(pair_.first, pair.first, [&](const auto& first) {
      withNode(pair_.second, pair.second,
               [&](const auto& second) { boundBy(first, second, pair_.pad(), pair.separation); });
    });
  }

  /// Ends as soon as the sets are proven to be far enough apart, or to be nearer.
  template <class First, class Second>
  void boundBy(const First& first, const Second& second, double pad, Separation& known) const {
    const double far_enough = farEnough();
    const GjkGoal gjk_goal{far_enough + pad, far_enough, 0, kNodeSteps};
    Simplex simplex;
    const GjkResult result =
        gjk(first, pair_.first_at, second, pair_.second_at, known.normal, gjk_goal, simplex);
    known.near = result.upper;
    known.raise(result.lower - pad, result.normal);
  }

  /// True if both shapes have triangles that no solid sweeps.
  bool haveTriangles() const {
    const TriangleTree* first = pair_.first.triangles.get();
    const TriangleTree* second = pair_.second.triangles.get();
    return first && second && first->solid == Solid::kNone && second->solid == Solid::kNone;
  }

  /// `counts`: these leaves are a part of the search, not only a first guess.
  void compareLeaves(const NodePair& pair, bool counts) {
    if (haveTriangles()) {
      compareTriangles(pair, counts);
      return;
    }
    Separation all{std::numeric_limits<double>::infinity(), 0, pair.separation.normal};
    forEachSet(pair_.first, pair.first, [&](std::uint32_t i, const auto& a) {
      forEachSet(pair_.second, pair.second, [&](std::uint32_t j, const auto& b) {
        const Separation sets = compareSets({i, j}, pair.separation, a, b);
        if (sets.lower < all.lower) all = sets;
      });
    });
    all.is_along = false;  // others may be proven along other normals
    if (counts) drop({pair.first, pair.second, all});
  }

  /// Calls `use` with a triangle, swept by the solid, or with a shape that has none.
  template <class Use>
  static void withSet(const BodyShape& shape, std::uint32_t triangle, const Use& use) {
    if (!shape.triangles) return use(ShapeHull{shape});
    const TriangleTree& tree = *shape.triangles;
    use(SweptTriangle{tree.corners(triangle), tree.solid, tree.size});
  }

  template <class Use>
  static void forEachSet(const BodyShape& shape, std::uint32_t leaf, const Use& use) {
    const TreeNode* node = shape.triangles ? &shape.triangles->nodes[leaf] : nullptr;
    const std::uint32_t begin = node ? node->first : 0, end = node ? begin + node->count : 1;
    for (std::uint32_t i = begin; i < end; ++i)
      withSet(shape, i, [&](const auto& set) { use(i, set); });
  }

  /// Raises the known bound of two sets by GJK and returns it.
  template <class First, class Second>
  Separation compareSets(const TrianglePair& sets, Separation known, const First& first,
                         const Second& second) {
    Simplex simplex;
    const double tolerance = kLeafTolerance * goal_.tolerance(hulls_.lower);
    const GjkGoal gjk_goal{farEnough() + pair_.pad(), 0, tolerance, kLeafSteps};
    const GjkResult result =
        gjk(first, pair_.first_at, second, pair_.second_at, known.normal, gjk_goal, simplex);
    known.raise(result.lower - pair_.pad(), result.normal);
    if (simplex.size() > 0) {
      offer(sets, pair_.first_at.toSearch(simplex.first()),
            pair_.second_at.toSearch(simplex.second()));
    }
    return known;
  }

  /// Most pairs of triangles are far enough apart along the direction that decided last, or across
  /// the plane of one of them.
  void compareTriangles(const NodePair& pair, bool counts) {
    const PlacedLeaf& first =
        scratch_.first_leaves.at(*pair_.first.triangles, pair.first, pair_.first_at);
    const PlacedLeaf& second =
        scratch_.second_leaves.at(*pair_.second.triangles, pair.second, pair_.second_at);
    LeafGaps gaps(first, second, pair_.rounding, pair.separation.normal);
    Separation all = pair.separation;
    all.raise(gaps.lower() - pair_.balls(), all.normal);
    if (!(all.lower >= farEnough())) {
      const double lower = compareTriangles(first, second, gaps, all.normal);
      all.lower = std::max(pair.separation.lower, lower);
      all.is_along = false;
    }
    if (counts) drop({pair.first, pair.second, all});
  }

  /// Returns how far all pairs are proven to be apart. `normal` becomes the last direction.
  double compareTriangles(const PlacedLeaf& first, const PlacedLeaf& second, LeafGaps& gaps,
                          Eigen::Vector3d& normal) {
    double lower = std::numeric_limits<double>::infinity();
    gaps.setFarEnough(farEnough() + pair_.balls());
    for (std::uint32_t i = 0; i < first.count; ++i) {
      if (!gaps.isOpen(i)) continue;
      gaps.raiseAcrossFirst(i);
      for (std::uint32_t j = 0; j < second.count; ++j) {
        if (!gaps.isOpen(i, j)) continue;
        gaps.raiseAcrossSecond(j);
        if (!gaps.isOpen(i, j)) continue;
        lower = std::min(lower, compare({first.first + i, second.first + j}, normal));
        gaps.close(i, j);
        gaps.raiseAlong(normal);
        gaps.setFarEnough(farEnough() + pair_.balls());
      }
    }
    return std::min(lower, gaps.lower() - pair_.balls());
  }

  /// Returns how far the two triangles are proven to be apart, and the direction that proves it.
  double compare(const TrianglePair& triangles, Eigen::Vector3d& normal) {
    const Triangle first = placed(*pair_.first.triangles, triangles.first, pair_.first_at);
    const Triangle second = placed(*pair_.second.triangles, triangles.second, pair_.second_at);
    const PointPair nearest = nearestPoints(first, second, farEnough() + pair_.pad());
    offer(triangles, nearest.on_first, nearest.on_second);
    const Eigen::Vector3d between = nearest.on_second - nearest.on_first;
    const double length = between.norm();
    if (!(length > kShortest)) return 0;
    normal = between / length;
    double gap = gapAlong(normal, first, second);
    if (gap - pair_.pad() >= farEnough()) return gap - pair_.pad();
    // The vector between points that nearly touch has few digits; the normals of the planes have
    // more.
    gap = std::max({gap, gapAcross(first, first, second), gapAcross(second, first, second)});
    double lower = gap - pair_.pad();
    if (lower >= farEnough()) return lower;
    // Where long edges are nearly parallel, supports have more digits than nearest points.
    withSet(pair_.first, triangles.first, [&](const auto& a) {
      withSet(pair_.second, triangles.second, [&](const auto& b) {
        lower = compareSets(triangles, {lower, 0, normal}, a, b).lower;
      });
    });
    return lower;
  }

  /// The gap of the two triangles along the normal of `triangle`, in either direction.
  static double gapAcross(const Triangle& triangle, const Triangle& first, const Triangle& second) {
    const Eigen::Vector3d across =
        (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).stableNormalized();
    return std::max(gapAlong(across, first, second), gapAlong(-across, first, second));
  }

  void offer(const TrianglePair& triangles, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    if (pair_.improve(witness_, a, b)) memory_.nearest = triangles;
  }

  const ShapePair& pair_;
  const NearestOfHulls& hulls_;
  const DistanceGoal& goal_;
  std::size_t& steps_left_;
  Witness& witness_;
  double lower_ = std::numeric_limits<double>::infinity();  ///< min of all dropped pairs
  bool keeps_front_ = false;
  TreeMemory& memory_;
  std::vector<FrontPair>& front_;  ///< all pairs that are dropped
  TreeScratch& scratch_;
  BoxPlacement first_boxes_;
  BoxPlacement second_boxes_;
  double box_pad_;
};

}  // namespace

double searchTrees(const ShapePair& pair, const NearestOfHulls& hulls, TreeMemory& memory,
                   const DistanceGoal& goal, std::size_t& steps_left, Witness& witness,
                   TreeScratch& scratch) {
  return NodeSearch(pair, hulls, goal, steps_left, witness, memory, scratch).run();
}

}  // namespace link_bounds

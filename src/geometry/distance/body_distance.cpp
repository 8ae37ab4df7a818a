// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches each pair of shapes, nearest boxes first: by boxes, then hulls, then triangles. A level
// is searched only if the one before it leaves the distance open.
#include "link_bounds/geometry/distance/body_distance.h"

#include <algorithm>
#include <cassert>

#include "geometry/distance/gjk.h"
#include "geometry/distance/placed_distance.h"
#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

/// Searches of the hulls of robots end within ten steps; this ends a search that rounding keeps
/// from converging.
constexpr int kHullSteps = 100;

/// After so much motion [m], the bounds of a memory are dropped and proven anew: up to here a float
/// resolves a micrometre.
constexpr double kFarthestMove = 4;

/// The share of the accuracy that hulls use; the rest is for the triangles.
constexpr double kHullTolerance = 0.25;

using Candidate = SearchRoom::ShapeIndices;

/// A shape that is its own convex hull.
bool isConvex(const BodyShape& shape) {
  if (shape.triangles) return shape.triangles->triangles.size() == 1;
  return !shape.shape.points || shape.shape.points->size() == 1;
}

/// All points of the shape are known, not only its convex hull.
bool isKnown(const BodyShape& shape) {
  return shape.triangles || isConvex(shape);
}

/// False for a vertex that no triangle uses.
[[maybe_unused]] bool isPoint(const BodyShape& shape, const Eigen::Vector3d& point) {
  return !shape.triangles || holdsPoint(*shape.triangles, point);
}

/// Unit, from the first box to the second; zero if no axis separates them.
Eigen::Vector3d boxNormal(const Aabb& first, const Aabb& second) {
  const Eigen::Vector3d gap =
      (second.min() - first.max()).cwiseMax(0.0) - (first.min() - second.max()).cwiseMax(0.0);
  return gap.stableNormalized();
}

/// A lower bound by the boxes. These are rounded outward, but computed from the rounded product of
/// two poses, so `rounding` is subtracted.
double boxLower(const Aabb& a, const Aabb& b, double rounding) {
  return std::max(0.0, signedDistance(a, b) * (1 - 8 * kUnitRoundoff) - rounding);
}

/// A little more than a limit.
double above(double limit) {
  return limit * (1 + 4 * kUnitRoundoff) + std::numeric_limits<double>::min();
}

double roundedUp(double distance, double rounding) {
  return (distance + rounding) * (1 + 8 * kUnitRoundoff);
}

class HullSearch {
 public:
  HullSearch(const PlacedBody& first, const PlacedBody& second, const DistanceGoal& goal,
             PairMemory& memory, SearchRoom& room, const Approach& motion)
      : first_(first),
        second_(second),
        goal_{goal.accuracy, above(goal.limit), goal.max_steps, goal.relative_accuracy},
        memory_(memory),
        room_(room),
        motion_(motion),
        rounding_(pairRounding(first, second)),
        steps_left_(goal.max_steps) {}

  /// The pair that was nearest before comes first, then those with the nearest boxes.
  BodyDistance run() {
    room_.open.clear();
    for (std::uint32_t i = 0; i < first_.shapes.size(); ++i) {
      for (std::uint32_t j = 0; j < second_.shapes.size(); ++j)
        room_.open.push_back(
            {i, j, boxLower(first_.shapes[i].box, second_.shapes[j].box, rounding_)});
    }
    if (memory_.is_known) {
      memory_.is_known = false;
      look(takeOut(memory_.first_shape * second_.shapes.size() + memory_.second_shape), true);
    }
    std::sort(room_.open.begin(), room_.open.end(),
              [](const Candidate& a, const Candidate& b) { return a.lower > b.lower; });
    while (!room_.open.empty() && !(room_.open.back().lower >= std::max(lower_, farEnough())))
      look(takeOut(room_.open.size() - 1), false);
    if (!memory_.is_known) memory_.trees = TreeMemory();
    if (!hasWitness()) takeAnyPoints();
    return result();
  }

 private:
  double farEnough() const { return goal_.enough(witness_.distance); }
  bool hasWitness() const { return witness_.distance < std::numeric_limits<double>::infinity(); }

  Candidate takeOut(std::size_t index) {
    std::swap(room_.open[index], room_.open.back());
    const Candidate result = room_.open.back();
    room_.open.pop_back();
    return result;
  }

  void look(const Candidate& candidate, bool is_remembered) {
    if (candidate.lower >= farEnough()) {
      decide(candidate.lower, DistanceLevel::kBox, boxNormalOf(candidate), candidate);
    } else {
      refine(candidate, is_remembered);
    }
  }

  Eigen::Vector3d boxNormalOf(const Candidate& pair) const {
    return boxNormal(first_.shapes[pair.first].box, second_.shapes[pair.second].box);
  }

  ShapePair shapePair(const Candidate& pair) const {
    const PlacedShape& a = first_.shapes[pair.first];
    const PlacedShape& b = second_.shapes[pair.second];
    ShapePair result{*a.shape,  *b.shape, a.from_body_origin, b.from_body_origin, a.ball, b.ball,
                     rounding_, motion_,  first_.rigid,       second_.rigid};
    result.second_at.translation += second_.origin - first_.origin;
    return result;
  }

  void refine(const Candidate& candidate, bool is_remembered) {
    const ShapePair pair = shapePair(candidate);
    const ShapeHull a = pair.firstHull(), b = pair.secondHull();
    Simplex simplex;
    if (is_remembered) place(memory_.simplex, pair, simplex);
    const double tolerance = kHullTolerance * goal_.tolerance(candidate.lower);
    const GjkGoal gjk_goal{farEnough() + pair.pad(), 0, tolerance, kHullSteps};
    const Eigen::Vector3d start = simplex.size() > 0 ? normal_ : startOf(candidate);
    const GjkResult hulls = gjk(a, pair.first_at, b, pair.second_at, start, gjk_goal, simplex);
    const double distance_before = witness_.distance;
    const double by_hulls = hulls.lower - pair.pad();
    const bool do_boxes_decide = candidate.lower >= by_hulls;
    double lower = do_boxes_decide ? candidate.lower : by_hulls;
    const Eigen::Vector3d normal = do_boxes_decide ? boxNormalOf(candidate) : hulls.normal;
    DistanceLevel level = do_boxes_decide ? DistanceLevel::kBox : DistanceLevel::kHull;
    // Nothing separates the hulls, so it is the hull level that decides.
    if (!(lower > 0)) level = DistanceLevel::kHull;
    TreeMemory trees = is_remembered ? std::move(memory_.trees) : TreeMemory();
    const bool are_convex = isConvex(pair.first) && isConvex(pair.second);
    const bool needs_trees =
        !(lower >= farEnough()) && isKnown(pair.first) && isKnown(pair.second) && !are_convex;
    // Where the bound suffices, nearer points are not needed.
    const bool is_far = by_hulls >= farEnough() && hasWitness();
    if (!is_far) offer(simplex, pair, are_convex);
    if (needs_trees && !(lower >= farEnough())) {
      const NearestOfHulls nearest{lower, hulls.lower > 0 ? hulls.normal : startOf(candidate),
                                   pair.first_at.toSearch(simplex.first()),
                                   pair.second_at.toSearch(simplex.second())};
      const double found =
          searchTrees(pair, nearest, trees, goal_, steps_left_, witness_, room_.trees);
      if (found > lower) level = DistanceLevel::kMesh;
      lower = found;
    }
    decide(lower, level, normal, candidate);
    if (witness_.distance < distance_before || !memory_.is_known) {
      memory_.is_known = true;
      memory_.first_shape = candidate.first;
      memory_.second_shape = candidate.second;
      memory_.simplex = simplex;
      memory_.trees = std::move(trees);
    }
  }

  /// A direction to begin with. The normal that separates the nearest shapes so far often separates
  /// others, too.
  Eigen::Vector3d startOf(const Candidate& pair) const {
    return normal_.squaredNorm() > 0 ? normal_ : betweenBoxes(pair);
  }

  Eigen::Vector3d betweenBoxes(const Candidate& pair) const {
    const Aabb& a = first_.shapes[pair.first].box;
    const Aabb& b = second_.shapes[pair.second].box;
    const Eigen::Vector3d normal = boxNormal(a, b);
    if (normal.squaredNorm() > 0) return normal;
    const Eigen::Vector3d between = (b.center() - a.center()).stableNormalized();
    return between.squaredNorm() > 0 ? between : Eigen::Vector3d::UnitX();
  }

  static void place(const Simplex& before, const ShapePair& pair, Simplex& simplex) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Eigen::Vector3d& a = before[i].first;
      const Eigen::Vector3d& b = before[i].second;
      simplex.add({pair.first_at.toSearch(a) - pair.second_at.toSearch(b), a, b});
    }
  }

  /// Offers a witness: for two convex shapes their nearest points, otherwise the nearest vertices
  /// of the simplex.
  void offer(const Simplex& simplex, const ShapePair& pair, bool are_convex) {
    if (are_convex && simplex.size() > 0) {
      pair.improve(witness_, pair.first_at.toSearch(simplex.first()),
                   pair.second_at.toSearch(simplex.second()));
      return;
    }
    std::array<Eigen::Vector3d, 4> on_second;
    for (std::size_t j = 0; j < simplex.size(); ++j)
      on_second[j] = pair.second_at.toSearch(simplex[j].second);
    double least = std::numeric_limits<double>::infinity();
    Eigen::Vector3d a = Eigen::Vector3d::Zero(), b = a;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      assert(isPoint(pair.first, simplex[i].first) && isPoint(pair.second, simplex[i].second));
      const Eigen::Vector3d on_first = pair.first_at.toSearch(simplex[i].first);
      for (std::size_t j = 0; j < simplex.size(); ++j) {
        const double squared = (on_second[j] - on_first).squaredNorm();
        if (!(squared < least)) continue;
        least = squared;
        a = on_first;
        b = on_second[j];
      }
    }
    if (least < std::numeric_limits<double>::infinity()) pair.improve(witness_, a, b);
  }

  void decide(double lower, DistanceLevel level, const Eigen::Vector3d& normal,
              const Candidate& pair) {
    if (!(lower < lower_)) return;
    lower_ = lower;
    level_ = level;
    normal_ = normal;
    nearest_ = pair;
  }

  /// Takes any points of the nearest pair: where boxes decided, no point is known yet.
  void takeAnyPoints() {
    const ShapePair pair = shapePair(nearest_);
    const Eigen::Vector3d normal = startOf(nearest_);
    const Eigen::Vector3d a = pair.firstHull().farthest(pair.first_at.toShape(normal));
    const Eigen::Vector3d b = pair.secondHull().farthest(-pair.second_at.toShape(normal));
    pair.improve(witness_, pair.first_at.toSearch(a), pair.second_at.toSearch(b));
  }

  BodyDistance result() const {
    const double upper = roundedUp(witness_.distance, rounding_);
    BodyDistance result{std::min(lower_, upper),
                        upper,
                        first_.origin + witness_.on_first,
                        first_.origin + witness_.on_second,
                        normal_,
                        level_};
    if (level_ == DistanceLevel::kMesh)
      result.normal = (witness_.on_second - witness_.on_first).stableNormalized();
    if (!(result.lower > 0)) result.normal.setZero();
    return result;
  }

  const PlacedBody& first_;
  const PlacedBody& second_;
  DistanceGoal goal_;  ///< its limit is slightly raised, so that a distance equal to it is searched
  PairMemory& memory_;
  SearchRoom& room_;
  const Approach& motion_;
  double rounding_;
  std::size_t steps_left_;
  Witness witness_;
  double lower_ = std::numeric_limits<double>::infinity();
  DistanceLevel level_ = DistanceLevel::kBox;
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  Candidate nearest_{0, 0, 0};
};

/// Adds the motion since the last call to the memory, which lowers its proven bounds. If that
/// motion is unknown or their sum is too large, drops the front and starts again at 0.
Approach aged(PairMemory& memory, const std::optional<RelativeMotion>& latest) {
  const double moved_then = memory.moved;
  if (latest) memory.moved = (moved_then + latest->approach) * (1 + 4 * kUnitRoundoff);
  if (latest && memory.moved <= kFarthestMove) return {memory.moved, moved_then, latest};
  memory.trees.front = Front();
  memory.moved = 0;
  return {0, 0, latest};
}

/// Fixes the order of two bodies, so that rounding is the same whichever the caller names first.
bool comesFirst(const PlacedBody& a, const PlacedBody& b) {
  using Key = std::array<double, 12>;
  const auto key = [](const PlacedBody& body) {
    Key result;
    Eigen::Map<Eigen::Matrix<double, 12, 1>>(result.data()) << body.origin, body.box.min(),
        body.box.max(), body.any_point;
    return result;
  };
  return key(a) < key(b);
}

}  // namespace

std::optional<BodyDistance> swapped(std::optional<BodyDistance> distance) {
  if (!distance) return distance;
  distance->on_first.swap(distance->on_second);
  distance->normal = Eigen::Vector3d::Zero() - distance->normal;  // never -0
  return distance;
}

std::optional<BodyDistance> distanceBeyond(double limit, const PlacedBody& first,
                                           const PlacedBody& second) {
  if (!(signedDistance(first.box, second.box) > limit)) return std::nullopt;
  const double rounding = pairRounding(first, second);
  const double lower = boxLower(first.box, second.box, rounding);
  if (!(lower > limit)) return std::nullopt;
  const Eigen::Vector3d on_first = first.origin + first.any_point;
  const Eigen::Vector3d on_second = second.origin + second.any_point;
  const Eigen::Vector3d apart =
      (second.origin - first.origin) + (second.any_point - first.any_point);
  return BodyDistance{lower,     roundedUp(apart.norm(), rounding), on_first,
                      on_second, boxNormal(first.box, second.box),  DistanceLevel::kBox};
}

BodyDistance placedDistance(const PlacedBody& first, const PlacedBody& second,
                            const DistanceGoal& goal, PairMemory& memory, SearchRoom& room,
                            const std::optional<RelativeMotion>& latest) {
  const Approach motion = aged(memory, latest);
  if (const auto far = distanceBeyond(goal.limit, first, second)) return *far;
  return HullSearch(first, second, goal, memory, room, motion).run();
}

std::optional<BodyDistance> bodyDistance(const Body& first, const Eigen::Affine3d& world_from_first,
                                         const Body& second,
                                         const Eigen::Affine3d& world_from_second,
                                         const DistanceGoal& goal) {
  const std::optional<PlacedBody> a = placedBody(first, world_from_first);
  const std::optional<PlacedBody> b = placedBody(second, world_from_second);
  if (!a || !b) return std::nullopt;
  PairMemory memory;
  SearchRoom room;
  if (comesFirst(*b, *a)) return swapped(placedDistance(*b, *a, goal, memory, room));
  return placedDistance(*a, *b, goal, memory, room);
}

}  // namespace link_bounds

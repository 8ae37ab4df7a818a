// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/placed_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "link_bounds/geometry/box/length.h"

namespace link_bounds {

PlacedPair::PlacedPair(JointPath path, const PairBody& first, const PairBody& second)
    : path_(std::move(path)),
      bodies_{&first, &second},
      motion_(path_, first.hull.cloud, second.hull.cloud) {}

void PlacedPair::begin() {
  for (const std::size_t i : {0u, 1u}) {
    distances_.set(i, bodies_[i]->body);
    hulls_.set(i, bodies_[i]->hull.body);
  }
  distances_.move(0, Eigen::Affine3d::Identity());
  hulls_.move(0, Eigen::Affine3d::Identity());
}

void PlacedPair::end() {
  distances_ = BodyDistances();
  hulls_ = BodyDistances();
}

void PlacedPair::enter(const JointBox& box) {
  place(box.center);
  motion_.set(box, placed_);
}

double PlacedPair::ballGap() const {
  const BodyCloud& a = first().hull.cloud;
  const BodyCloud& b = second().hull.cloud;
  const Eigen::Vector3d between = placed_.first_from_second * b.center() - a.center();
  const double gap = length(between.x(), between.y(), between.z()) - a.radius() - b.radius();
  return std::isfinite(gap) ? gap : 0;  // an overflow proves nothing
}

std::optional<BodyDistance> PlacedPair::distance(const DistanceGoal& goal) {
  distances_.move(1, pose());
  distances_.setGoal(goal);
  return distances_.find(0, 1);
}

DistanceGoal PlacedPair::goalFor(double enough) const {
  return {std::max(PairGoal::kPoseAccuracy, PairGoal::kShareOfMotion * motion()), enough + motion(),
          PairGoal::kMaxTreeSteps};
}

std::optional<double> PlacedPair::hullBound(const DistanceGoal& goal, double enough) {
  hulls_.move(1, pose());
  hulls_.setGoal(goal);
  const std::optional<BodyDistance> hulls = hulls_.find(0, 1);
  if (!hulls) return std::nullopt;
  const double lower = hulls->lower - motion();
  if (lower >= enough || hulls->lower <= 0) return lower;
  const double along = motion_.gapAlong(hulls->normal, first().hull.cloud, second().hull.cloud);
  return std::max(lower, along - rounding());
}

double PlacedPair::partsBound(const DistanceGoal& goal, double enough) const {
  if (first().parts.empty() && second().parts.empty()) return 0;
  double lower = std::numeric_limits<double>::infinity();
  for (const PairHull* a : partsOf(first())) {
    for (const PairHull* b : partsOf(second())) {
      const std::optional<BodyDistance> distance =
          bodyDistance(*a->body, Eigen::Affine3d::Identity(), *b->body, pose(), goal);
      if (!distance || !(distance->lower > 0)) return 0;
      double of_pair = distance->lower - motion_.motion();
      if (of_pair < enough)
        of_pair = std::max(of_pair, motion_.gapAlong(distance->normal, a->cloud, b->cloud));
      lower = std::min(lower, of_pair - rounding());
      if (!(lower > 0)) return 0;
    }
  }
  return lower;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sweeps with a wider margin than asked for. Until a box has moved farther than that slack allows,
// the pairs of the sweep contain all pairs that are near, and no other sweep is needed.
#include "link_bounds/geometry/pairs/sweep_and_prune.h"

#include "geometry/pairs/box_sample.h"
#include "geometry/pairs/sweep.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

// Twice the slack makes a search of 10,000 boxes up to 1.13 times as slow, because each call
// compares more pairs. Half the slack makes it up to 1.6 times as slow, because sweeps are more
// frequent.
constexpr double kSlack = 0.1;   ///< of the longest side of a typical box
constexpr double kMinSteps = 4;  ///< a slack that lasts for fewer steps costs more than it saves

/// How far any side moved [m].
double motion(const std::vector<Aabb>& from, const std::vector<Aabb>& to) {
  Eigen::Array3d farthest = Eigen::Array3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    farthest = farthest.max((to[i].min() - from[i].min()).array().abs())
                   .max((to[i].max() - from[i].max()).array().abs());
  }
  return farthest.maxCoeff();
}

/// `speed`: how far the fastest side moves in a step [m].
double slackFor(const std::vector<Aabb>& boxes, double speed) {
  if (boxes.empty()) return 0;
  const BoxSample sample(boxes);
  const auto length = [](const Aabb& box) { return box.sizes().maxCoeff(); };
  const double slack = kSlack * sample.median(length);
  return slack >= kMinSteps * speed ? slack : 0;
}

}  // namespace

/// The pairs of the last sweep, and the boxes and margin that they are valid for.
class SweepAndPrune::Candidates {
 public:
  /// All pairs with distance <= margin and some others, sorted.
  const std::vector<IndexPair>& find(const std::vector<Aabb>& boxes, double margin) {
    ++steps_;
    if (boxes.size() == boxes_.size() && margin == margin_) {
      const double moved = motion(boxes_, boxes);
      if (moved <= slack_) return pairs_;
      speed_ = moved / static_cast<double>(steps_);
    }
    margin_ = -1;  // if the memory runs out below, no pairs are valid
    boxes_ = boxes;
    slack_ = slackFor(boxes, speed_);
    steps_ = 0;
    // Two boxes may approach each other by twice the slack. signedDistance() may round a distance
    // down, and motion() how far a side moved.
    sweep_.find(boxes, addUp(margin * (1 + 1e-15), slack_ * (2 + 1e-9)), pairs_);
    margin_ = margin;
    return pairs_;
  }

 private:
  Sweep sweep_;
  std::vector<IndexPair> pairs_;
  std::vector<Aabb> boxes_;
  double margin_ = -1;
  double slack_ = 0;       ///< how far each side of each box may move before the next sweep [m]
  std::size_t steps_ = 0;  ///< since the sweep
  double speed_ = 0;       ///< before the sweep, see slackFor()
};

SweepAndPrune::SweepAndPrune() : candidates_(std::make_unique<Candidates>()) {}
SweepAndPrune::~SweepAndPrune() = default;
SweepAndPrune::SweepAndPrune(SweepAndPrune&& other) noexcept = default;
SweepAndPrune& SweepAndPrune::operator=(SweepAndPrune&& other) noexcept = default;

const std::vector<BoxPair>& SweepAndPrune::find(const std::vector<Aabb>& boxes, double margin) {
  pairs_.clear();
  for (const IndexPair pair : candidates_->find(boxes, margin)) {
    const std::size_t first = firstOf(pair);
    const std::size_t second = secondOf(pair);
    const double distance = signedDistance(boxes[first], boxes[second]);
    if (distance <= margin) pairs_.push_back({first, second, distance});
  }
  return pairs_;
}

}  // namespace link_bounds

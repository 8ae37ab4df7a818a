// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Branch and bound over all pairs and the time together: the interval with the smallest bound is
// halved first, until the bound that is proven for all intervals is near to the smallest distance
// that was found.
#include "robot/posed/path_prover.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <queue>
#include <tuple>

#include "robot/pairs/placed_pair.h"

namespace link_bounds {
namespace {

/// Max steps for one segment: a search that takes more ends undecided.
constexpr std::size_t kMaxSteps = 200'000;

/// Max shares of a segment whose joint values are kept.
constexpr std::size_t kMaxKeptShares = 10'000;

/// Beyond any robot [m].
constexpr double kFarthest = 1e9;

}  // namespace

const char* toText(PathVerdict verdict) {
  constexpr std::array<const char*, 3> kTexts{"SAFE", "COLLIDES", "UNDECIDED"};
  return kTexts.at(static_cast<std::size_t>(verdict));
}

std::vector<JointRange> rangesOf(const Robot& robot, const std::vector<Limits>& limits) {
  const std::vector<Lead> leads = leadsOf(robot);
  std::vector<JointRange> ranges;
  for (const Lead& lead : leads) {
    const Limits& leader = limits[lead.leader];
    const auto [lower, upper] = std::minmax(
        {lead.factor * leader.lower + lead.offset, lead.factor * leader.upper + lead.offset});
    ranges.push_back({lower, upper, lead});
  }
  return ranges;
}

class PathProver::Search {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  struct Pair {
    std::size_t first;  ///< body
    std::size_t second;
    PlacedPair placed;
    std::size_t segment = 0;  ///< to which the memories belong; 0: none

    Pair(std::size_t its_first, std::size_t its_second, JointPath path, const PairBody& a,
         const PairBody& b)
        : first(its_first), second(its_second), placed(std::move(path), a, b) {}
  };

  /// An interval of shares, for one pair.
  struct Node {
    double lower;  ///< proven [m]
    std::size_t pair;
    double middle;
    double half;

    /// The smallest bound comes first; of equal bounds, the earlier pair, so that the order is
    /// always the same.
    bool operator<(const Node& other) const {
      return std::tie(lower, pair, middle) > std::tie(other.lower, other.pair, other.middle);
    }
  };

 public:
  Search(const Robot& robot, const std::vector<PathBody>& bodies, const Pairs& pairs,
         const std::vector<Limits>& limits, const PathGoal& goal)
      : goal_(goal) {
    const std::vector<JointRange> ranges = rangesOf(robot, limits);
    for (const PathBody& body : bodies)
      bodies_.push_back(pairBody(body.body));
    for (const auto& [first, second] : pairs) {
      const PairBody& a = bodies_[first];
      const PairBody& b = bodies_[second];
      if (!bodies[first].is_whole || !bodies[second].is_whole) is_whole_ = false;
      if (a.body->shapes.empty() || b.body->shapes.empty()) continue;
      pairs_.emplace_back(first, second,
                          jointPath(robot, ranges, bodies[first].link, bodies[second].link), a, b);
    }
  }

  SegmentProof prove(const JointMotion& motion, const std::function<bool()>& is_over) {
    motion_ = &motion;
    proof_ = {};
    proven_ = kInfinity;
    ++segment_;
    nodes_ = {};
    values_.clear();
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair)
      nodes_.push({0, pair, 0.5, 0.5});
    for (const double end : {0.0, 1.0}) {
      for (std::size_t pair = 0; pair < pairs_.size() && !collides() && !is_over(); ++pair)
        measureEnd(pair, end);
    }
    std::size_t steps = 0;
    while (!collides() && !nodes_.empty() && nodes_.top().lower < enough()) {
      if (++steps > kMaxSteps || is_over()) break;
      const Node node = nodes_.top();
      nodes_.pop();
      branch(node);
    }
    finish();
    return proof_;
  }

 private:
  bool isTouch(double distance) const { return distance <= goal_.clearance + PairGoal::kTouch; }
  bool collides() const { return isTouch(proof_.nearest); }

  /// An interval whose bound is at least this is not halved further [m].
  double enough() const {
    return std::max(proof_.nearest - goal_.accuracy, goal_.clearance + PairGoal::kProof);
  }

  void finish() {
    if (!nodes_.empty()) proven_ = std::min(proven_, nodes_.top().lower);
    if (is_whole_ && proof_.nearest < kInfinity)
      proof_.clearance = std::max(0.0, std::min(proven_, proof_.nearest));
    if (collides()) {
      proof_.verdict = PathVerdict::kCollides;
    } else if (is_whole_ && !pairs_.empty() && proof_.clearance > goal_.clearance) {
      proof_.verdict = PathVerdict::kSafe;
    }
  }

  /// The values of all joints at that share, until the next call. Kept, because intervals of many
  /// pairs have the same middle.
  const std::vector<double>& valuesAt(double share) {
    if (values_.size() >= kMaxKeptShares) values_.clear();
    const auto [entry, is_new] = values_.try_emplace(share);
    if (is_new) entry->second = motion_->at(share);
    return entry->second;
  }

  /// Memories end with the segment, so that no segment depends on those before it.
  Pair& begun(std::size_t index) {
    Pair& pair = pairs_[index];
    if (pair.segment != segment_) pair.placed.begin();
    pair.segment = segment_;
    return pair;
  }

  PathValues valuesAt(const Pair& pair, double share) {
    const std::vector<double>& values = valuesAt(share);
    PathValues result;
    for (const std::size_t joint : pair.placed.path().variables)
      result.push_back(values[joint]);
    return result;
  }

  std::optional<BodyDistance> distanceOf(PlacedPair& pair, const DistanceGoal& goal) const {
    std::optional<BodyDistance> distance = pair.distance(goal);
    // If a contact is possible, measures it exactly at once.
    if (distance && distance->lower <= goal_.clearance && !isTouch(distance->upper)) {
      distance = pair.distance(
          {PairGoal::kPoseAccuracy, goal_.clearance + goal.accuracy, PairGoal::kMaxTreeSteps});
    }
    return distance;
  }

  void offer(const Pair& pair, const BodyDistance& distance, double share) {
    const double upper = distance.upper + pair.placed.rounding();
    if (!(upper < proof_.nearest)) return;
    proof_.nearest = upper;
    proof_.first = pair.first;
    proof_.second = pair.second;
    proof_.share = share;
  }

  void measureEnd(std::size_t index, double share) {
    Pair& pair = begun(index);
    pair.placed.place(valuesAt(pair, share));
    if (pair.placed.ballGap() >= proof_.nearest) return;
    const double limit = std::min(proof_.nearest, kFarthest);
    const auto distance =
        distanceOf(pair.placed, {goal_.accuracy / 10, limit, PairGoal::kMaxTreeSteps});
    if (distance) offer(pair, *distance, share);
  }

  void branch(Node node) {
    node.lower = std::max(node.lower, bound(node));
    if (node.lower >= enough() || pairs_[node.pair].placed.path().variables.empty()) {
      proven_ = std::min(proven_, node.lower);
      return;
    }
    const double half = node.half / 2;
    nodes_.push({node.lower, node.pair, node.middle - half, half});
    nodes_.push({node.lower, node.pair, node.middle + half, half});
  }

  /// A lower bound of the distance in the interval [m]; cheap bounds are tried first.
  double bound(const Node& node) {
    Pair& pair = begun(node.pair);
    PlacedPair& placed = pair.placed;
    JointBox box{valuesAt(pair, node.middle), {}};
    for (const std::size_t joint : placed.path().variables)
      box.half_widths.push_back(motion_->spread(joint, node.middle, node.half));
    placed.enter(box);
    double lower = placed.ballGap() - placed.motion();
    if (lower >= enough()) return lower;
    const DistanceGoal goal = placed.goalFor(std::min(enough(), kFarthest));
    const std::optional<double> hulls = placed.hullBound(goal, enough());
    if (!hulls) return 0;
    lower = std::max(lower, *hulls);
    if (lower >= enough()) return lower;
    const std::optional<BodyDistance> distance = distanceOf(placed, goal);
    if (!distance) return lower;
    offer(pair, *distance, node.middle);
    return std::max(lower, distance->lower - placed.motion());
  }

  const PathGoal goal_;
  std::deque<PairBody> bodies_;
  std::deque<Pair> pairs_;
  bool is_whole_ = true;
  std::size_t segment_ = 0;
  const JointMotion* motion_ = nullptr;
  SegmentProof proof_;
  double proven_ = kInfinity;  ///< min of all intervals that need no more halving
  std::priority_queue<Node> nodes_;
  std::map<double, std::vector<double>> values_;  ///< values of all joints, by share
};

PathProver::PathProver(const Robot& robot, const std::vector<PathBody>& bodies, const Pairs& pairs,
                       const std::vector<Limits>& ranges, const PathGoal& goal)
    : search_(std::make_unique<Search>(robot, bodies, pairs, ranges, goal)) {}
PathProver::PathProver(PathProver&&) noexcept = default;
PathProver::~PathProver() = default;

SegmentProof PathProver::prove(const JointMotion& motion, const std::function<bool()>& is_over) {
  const auto begin = std::chrono::steady_clock::now();
  SegmentProof proof = search_->prove(motion, is_over);
  proof.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return proof;
}

}  // namespace link_bounds

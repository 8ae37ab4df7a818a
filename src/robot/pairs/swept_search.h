// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One pair with fewer joints: the joint next to a body is left out, and the body replaced by what
// it fills while it turns about that joint. What is proven of the larger bodies holds for the pair.
//
// This pays for joints about which a body is nearly round, such as wheels and the rolls of an arm,
// and where the bodies stay far from each other.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>

#include "robot/pairs/pair_search.h"

namespace link_bounds {

/// Cylinders about an axis through the origin that hold the body at any angle. `pose` places the
/// body; `axis` is a unit vector.
Body sweptBody(const Body& body, const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis);

class SweptSearch {
 public:
  /// `nearest` is a distance at which a pose was found [m]. Refers to the bodies.
  SweptSearch(const JointPath& path, const PairBody& first, const PairBody& second,
              const PairGoal& goal, double nearest);

  /// Some of the work.
  void advance();

  /// Where the swept bodies came nearer to each other than the given ones have: values of some of
  /// the variables, by the robot's joint. Empty if they did not; each one is given once.
  std::map<std::size_t, double> takeHint() { return std::exchange(hint_, {}); }

  bool isDone() const { return !candidate_ && (!chosen_ || chosen_->search->isDone()); }
  /// No pose of the pair has a smaller distance [m].
  double clearance() const { return chosen_ ? std::max(0.0, chosen_->search->clearance()) : 0; }
  std::size_t bytes() const;

 private:
  /// Bodies that are swept so far.
  struct Stage {
    JointPath path;
    std::shared_ptr<const PairBody> first;
    std::shared_ptr<const PairBody> second;
    std::unique_ptr<PairSearch> search;
  };

  void nextCandidate();
  std::unique_ptr<Stage> swept(const Stage& stage, bool at_second) const;

  PairGoal goal_;
  double nearest_;  ///< of the stage that `candidate_` was made of [m]
  Stage given_;     ///< without a search
  std::unique_ptr<Stage> chosen_;
  std::unique_ptr<Stage> candidate_;  ///< may turn out to collide
  bool is_at_second_ = false;         ///< what was swept for the candidate
  std::map<std::size_t, double> hint_;
  std::array<bool, 2> is_settled_{};  ///< the first, the second body is not swept further
};

}  // namespace link_bounds

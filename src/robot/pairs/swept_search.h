// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches one pair with fewer joints: the joint next to a body is left out, and the body is
// replaced by the volume that it fills while it turns about that joint. A clearance that is proven
// for the larger bodies holds for the pair, too.
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
  /// `nearest` is the smallest distance found so far [m]. Refers to the bodies.
  SweptSearch(const JointPath& path, const PairBody& first, const PairBody& second,
              const PairGoal& goal, double nearest);

  /// Does some of the work.
  void advance();

  /// The nearest pose that was found for swept bodies, as a start for the given ones: values of
  /// some of the variables, by the robot's joint. Each one is given once; otherwise empty.
  std::map<std::size_t, double> takeHint() { return std::exchange(hint_, {}); }

  bool isDone() const { return !candidate_ && (!chosen_ || chosen_->search->isDone()); }
  /// No pose of the pair has a smaller distance [m].
  double clearance() const { return chosen_ ? std::max(0.0, chosen_->search->clearance()) : 0; }
  std::size_t bytes() const;

 private:
  /// The pair after some sweeps, with the joints that are left.
  struct Stage {
    JointPath path;
    std::shared_ptr<const PairBody> first;
    std::shared_ptr<const PairBody> second;
    std::unique_ptr<PairSearch> search;
  };

  void nextCandidate();
  std::unique_ptr<Stage> swept(const Stage& stage, bool at_second) const;

  PairGoal goal_;
  double nearest_;  ///< smallest distance found for the stage that `candidate_` was made from [m]
  Stage given_;     ///< without a search
  std::unique_ptr<Stage> chosen_;
  std::unique_ptr<Stage> candidate_;  ///< may turn out to collide
  bool is_at_second_ = false;         ///< the second body was swept for it
  std::map<std::size_t, double> hint_;
  std::array<bool, 2> is_settled_{};  ///< by body: it is not swept further
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether two bodies can collide while their joints move in their ranges: branch and bound over the
// joints between them.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <queue>
#include <random>
#include <vector>

#include "robot/pairs/placed_pair.h"

namespace link_bounds {

/// A pose with two proven bounds of the distance of the bodies [m].
struct KnownPose {
  PathValues values;
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
};

class SweptSearch;

/// One pair, searched in slices. All ranges of the path must be known. Refers to the bodies.
class PairSearch {
 public:
  /// With `may_sweep` a pair that takes long is also searched by SweptSearch.
  PairSearch(JointPath path, const PairBody& first, const PairBody& second, const PairGoal& goal,
             bool may_sweep = true);
  ~PairSearch();
  PairSearch(const PairSearch&) = delete;
  PairSearch& operator=(const PairSearch&) = delete;

  /// Does one slice of the work.
  void advance();

  /// True if no work is left.
  bool isDone() const { return is_done_; }
  /// True if the remaining work can only raise clearance().
  bool isDecided() const {
    return is_done_ || isFree() || alwaysTouches() || (collides() && was_apart_);
  }
  bool collides() const;
  /// Proven: no pose in the ranges collides.
  bool isFree() const;
  bool alwaysCollides() const { return contact_ == Contact::kColliding; }
  /// Proven: no pose in the ranges is farther apart than PairGoal::touching.
  bool alwaysTouches() const { return contact_ != Contact::kNone; }
  /// True if a pose was found that does not collide.
  bool hasFreePose() const { return was_free_; }
  /// True if all random poses were tried, or the only pose that there is.
  bool isSampled() const;
  /// True if isSampled(), and descents from the nearest of these poses have ended.
  bool isExplored() const { return isSampled() && starts_.empty(); }
  std::size_t poses() const { return poses_; }  ///< that were tried

  /// Proven: no pose in the ranges has a smaller distance [m].
  double clearance() const;
  const KnownPose& nearest() const { return nearest_; }
  const JointPath& path() const { return pair_.path(); }

  std::size_t slices() const { return slices_; }  ///< calls of advance()
  /// Memory in use, roughly.
  std::size_t bytes() const;

 private:
  enum class Contact { kNone, kTouching, kColliding };

  struct Node {
    double lower;  ///< proven for the whole box
    JointBox box;

    bool operator<(const Node& other) const { return lower > other.lower; }
  };

  void shortenPose();
  void sample();
  void descend(KnownPose pose);
  PathValues moved(PathValues values, const PathValues& way) const;
  PathValues way(double step, std::size_t direction);
  /// If the distance exceeds `limit`, only that is known of it.
  KnownPose measured(const PathValues& values,
                     double limit = std::numeric_limits<double>::infinity());
  void offer(const KnownPose& pose);
  bool sweep();
  void follow(const std::map<std::size_t, double>& hint);
  void branch();
  double bound(const JointBox& box);
  bool mayTouch() const;
  void proveContact();
  bool isHopeless() const;
  void beginContact();
  void endContact(bool is_proven);
  bool isContactIn(const JointBox& box);
  void addHalves(Node node);
  void add(Node node);
  Node take();
  double enough() const;
  void finish();
  bool isTouch(double distance) const;

  PlacedPair pair_;
  PairGoal goal_;
  std::mt19937_64 random_;
  std::vector<KnownPose> starts_;  ///< from which descents begin
  int samples_ = 0;
  std::size_t max_nodes_ = 0;
  KnownPose nearest_;
  std::size_t poses_ = 0;
  std::size_t slices_ = 0;
  bool was_free_ = false;   ///< in a pose that was tried
  bool was_apart_ = false;  ///< in a pose that was tried: farther apart than PairGoal::touching
  std::priority_queue<Node> nodes_;
  std::vector<Node> latest_;  ///< boxes beyond max_nodes_; searched first, so that memory is
                              ///< bounded
  double dropped_ = std::numeric_limits<double>::infinity();  ///< smallest bound of dropped nodes
  Contact aim_ = Contact::kColliding;                         ///< what this search tries to prove
  Contact contact_ = Contact::kNone;                          ///< what is proven for all poses
  std::vector<JointBox> open_;  ///< in which the aim is not yet proven
  int open_steps_ = 0;
  double closed_ = 0;  ///< share of the ranges where the aim is proven
  bool may_sweep_;
  std::size_t branch_slices_ = 0;
  std::unique_ptr<SweptSearch> swept_;
  double swept_clearance_ = 0;  ///< proven by `swept_`
  bool is_done_ = false;
};

}  // namespace link_bounds

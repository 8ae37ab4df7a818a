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

/// Where the distance of the bodies is between two proven bounds.
struct KnownPose {
  PathValues values;
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
};

class SweptSearch;

/// One pair, searched in slices. All ranges of the path must be known. Refers to the bodies.
class PairSearch {
 public:
  /// With `may_sweep` a pair that takes long is also searched as SweptSearch does.
  PairSearch(JointPath path, const PairBody& first, const PairBody& second, const PairGoal& goal,
             bool may_sweep = true);
  ~PairSearch();
  PairSearch(const PairSearch&) = delete;
  PairSearch& operator=(const PairSearch&) = delete;

  /// Some of the work.
  void advance();

  /// Nothing is left that could be done.
  bool isDone() const { return is_done_; }
  /// What is left can only raise clearance().
  bool isDecided() const {
    return is_done_ || isFree() || alwaysTouches() || (collides() && was_apart_);
  }
  bool collides() const;
  /// No pose in the ranges collides.
  bool isFree() const;
  bool alwaysCollides() const { return contact_ == Contact::kColliding; }
  /// No pose in the ranges is farther apart than PairGoal::touching.
  bool alwaysTouches() const { return contact_ != Contact::kNone; }
  /// A pose was found that does not collide.
  bool hasFreePose() const { return was_free_; }
  /// All random poses were tried, or the only pose that there is.
  bool isSampled() const;
  /// isSampled(), and descents from the nearest of these poses have ended.
  bool isExplored() const { return isSampled() && starts_.empty(); }
  std::size_t poses() const { return poses_; }  ///< that were tried

  /// No pose in the ranges has a smaller distance [m].
  double clearance() const;
  const KnownPose& nearest() const { return nearest_; }
  const JointPath& path() const { return pair_.path(); }

  std::size_t slices() const { return slices_; }  ///< calls of advance()
  /// In memory, roughly.
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
  /// Of a pose that is farther than the limit it is only known that it is.
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
  std::vector<KnownPose> starts_;  ///< of descents
  int samples_ = 0;
  std::size_t max_nodes_ = 0;
  KnownPose nearest_;
  std::size_t poses_ = 0;
  std::size_t slices_ = 0;
  bool was_free_ = false;   ///< in a pose that was tried
  bool was_apart_ = false;  ///< likewise, and farther than PairGoal::touching
  std::priority_queue<Node> nodes_;
  std::vector<Node> latest_;  ///< searched first, so that memory is bounded
  double dropped_ = std::numeric_limits<double>::infinity();  ///< smallest bound of dropped nodes
  Contact aim_ = Contact::kColliding;                         ///< what is tried to be proven
  Contact contact_ = Contact::kNone;                          ///< what is proven of all poses
  std::vector<JointBox> open_;                                ///< where the aim is not proven
  int open_steps_ = 0;
  double closed_ = 0;  ///< share of the ranges where the aim is proven
  bool may_sweep_;
  std::size_t branch_slices_ = 0;
  std::unique_ptr<SweptSearch> swept_;
  double swept_clearance_ = 0;  ///< proven by `swept_`
  bool is_done_ = false;
};

}  // namespace link_bounds

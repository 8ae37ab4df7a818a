// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two bodies on the chain of joints between them, at one pose and in a box of joint values around
// it; and the goal of proofs about them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "link_bounds/geometry/distance/body_distances.h"
#include "robot/pairs/motion_bound.h"
#include "robot/pairs/pair_body.h"

namespace link_bounds {

struct PairGoal {
  /// Bodies this near touch [m]: a float32 vertex at 1 m is rounded by as much.
  static constexpr double kTouch = 1e-7;

  /// A bound that exceeds the clearance by this proves that the distance exceeds it, too [m].
  static constexpr double kProof = 1e-9;

  /// Accuracy of distances: in one pose [m], and as a share of the motion in a box or an interval.
  static constexpr double kPoseAccuracy = kTouch / 4;
  static constexpr double kShareOfMotion = 0.1;

  /// Max steps of one distance, see DistanceGoal::max_steps.
  static constexpr std::size_t kMaxTreeSteps = 100'000;

  double clearance = 0;    ///< bodies at most this far apart collide [m]
  double accuracy = 0.01;  ///< of the clearance that is proven [m]
  double touching = 1e-4;  ///< bodies at most this far apart in all poses always touch [m]
};

class PlacedPair {
 public:
  /// Refers to the bodies.
  PlacedPair(JointPath path, const PairBody& first, const PairBody& second);
  PlacedPair(const PlacedPair&) = delete;
  PlacedPair& operator=(const PlacedPair&) = delete;

  /// Starts with empty memories, so that results do not depend on earlier ones.
  void begin();
  /// Frees the memories of the distances. No distance is asked for afterwards.
  void end();

  const JointPath& path() const { return path_; }
  const PairBody& first() const { return *bodies_[0]; }
  const PairBody& second() const { return *bodies_[1]; }

  /// Places the bodies at these values.
  void place(const PathValues& values) { path_.place(values, placed_); }
  /// Places the bodies at the centre of the box. The bounds below hold in the whole box.
  void enter(const JointBox& box);

  /// The pose of the second body in the frame of the first one.
  Eigen::Affine3d pose() const { return Eigen::Affine3d(placed_.first_from_second); }
  /// How far balls around the bodies are apart where they are placed, without rounding [m].
  double ballGap() const;
  std::optional<BodyDistance> distance(const DistanceGoal& goal);

  /// Max error of a distance due to rounding of poses [m].
  double rounding() const { return motion_.rounding(); }
  /// Anywhere in the box, the distance is at least that at the centre less this [m].
  double motion() const { return motion_.motion() + motion_.rounding(); }
  /// The variable of the box that adds most to motion().
  std::size_t widestVariable() const { return motion_.widestVariable(); }
  /// The goal of a distance at the centre that is to prove `enough` for the whole box [m].
  DistanceGoal goalFor(double enough) const;
  /// Anywhere in the box the hulls are at least this far apart [m]; nothing if it is not known.
  /// Tries more where that is less than `enough`.
  std::optional<double> hullBound(const DistanceGoal& goal, double enough);
  /// As hullBound(), with the hulls of single shapes, which may be apart where those of the bodies
  /// overlap; 0 if it is not known.
  double partsBound(const DistanceGoal& goal, double enough) const;

 private:
  JointPath path_;
  std::array<const PairBody*, 2> bodies_;
  MotionBound motion_;
  PlacedPath placed_;
  BodyDistances distances_;
  BodyDistances hulls_;
};

}  // namespace link_bounds

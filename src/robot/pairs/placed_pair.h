// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two bodies on the chain of joints between them, at one pose and in a box of joint values around
// it; and what is to be proven of them.
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

  /// A bound that exceeds the clearance by this proves that it is not undercut [m].
  static constexpr double kProof = 1e-9;

  /// Accuracy of distances: of poses [m], and beside the motion of a box or an interval.
  static constexpr double kPoseAccuracy = kTouch / 4;
  static constexpr double kShareOfMotion = 0.1;

  /// What a distance may take, see DistanceGoal.
  static constexpr std::size_t kMaxTreeSteps = 100'000;

  double clearance = 0;    ///< bodies that are as near collide [m]
  double accuracy = 0.01;  ///< of the clearance that is proven [m]
  double touching = 1e-4;  ///< bodies that are as near in all poses touch always [m]
};

class PlacedPair {
 public:
  /// Refers to the bodies.
  PlacedPair(JointPath path, const PairBody& first, const PairBody& second);
  PlacedPair(const PlacedPair&) = delete;
  PlacedPair& operator=(const PlacedPair&) = delete;

  /// What follows does not depend on what was asked before.
  void begin();
  /// Frees the memories of the distances. No distance is asked for afterwards.
  void end();

  const JointPath& path() const { return path_; }
  const PairBody& first() const { return *bodies_[0]; }
  const PairBody& second() const { return *bodies_[1]; }

  /// At these values.
  void place(const PathValues& values) { path_.place(values, placed_); }
  /// At the centre of the box. Bounds are of the whole box.
  void enter(const JointBox& box);

  /// The pose of the second body in the frame of the first one.
  Eigen::Affine3d pose() const { return Eigen::Affine3d(placed_.first_from_second); }
  /// How far balls around the bodies are apart where they are placed, without rounding [m].
  double ballGap() const;
  std::optional<BodyDistance> distance(const DistanceGoal& goal);

  /// What rounding of poses can make a distance wrong by [m].
  double rounding() const { return motion_.rounding(); }
  /// In the box, the distance is less than at the centre by at most this [m].
  double motion() const { return motion_.motion() + motion_.rounding(); }
  /// Of the box, the variable that adds most to motion().
  std::size_t widestVariable() const { return motion_.widestVariable(); }
  /// What a distance at the centre may take where `enough` is to be proven of the box.
  DistanceGoal goalFor(double enough) const;
  /// Anywhere in the box the hulls are at least this far apart [m]; nothing if it is not known.
  /// Tries more where that is less than `enough`.
  std::optional<double> hullBound(const DistanceGoal& goal, double enough);
  /// The same of the hulls of single shapes, which may be apart where those of all overlap; 0 if it
  /// is not known.
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

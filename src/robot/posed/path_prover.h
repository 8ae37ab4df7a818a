// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a robot collides on its way from one way point to the next: the motion bound of the
// proofs over joint ranges, with time as the one dimension.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "link_bounds/geometry/distance/body.h"
#include "link_bounds/robot/urdf/robot.h"
#include "robot/posed/joint_motion.h"

namespace link_bounds {

/// A link, or an object that is fixed to a link.
struct PathBody {
  std::size_t link;  ///< index in Robot::links; `body` is in its frame
  Body body;
  bool is_whole = true;  ///< nothing of its geometry is missing
};

struct PathGoal {
  double clearance = 0;    ///< bodies at most this far apart collide [m]
  double accuracy = 0.01;  ///< of the clearance that is proven [m]
};

enum class PathVerdict {
  kSafe,      ///< proven: no pose on the way collides
  kCollides,  ///< a pose on the way collides
  kUndecided
};

/// SAFE, COLLIDES or UNDECIDED.
const char* toText(PathVerdict verdict);

struct SegmentProof {
  PathVerdict verdict = PathVerdict::kUndecided;
  double clearance = 0;  ///< proven: no examined pair comes nearer [m]; 0 if a body is incomplete
  /// Upper bound of the distance of the bodies `first` and `second` at `share` [m]; infinite if no
  /// pose was measured.
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t first = 0;
  std::size_t second = 0;
  double share = 0;    ///< of the time from one way point to the next
  double seconds = 0;  ///< that the search took
};

/// The ranges of all joints, from the limits of the joints that mimic no other one.
std::vector<JointRange> rangesOf(const Robot& robot, const std::vector<Limits>& limits);

/// Proofs about the same bodies, one after the other. No proof depends on those before. Not
/// thread-safe.
class PathProver {
 public:
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

  /// `robot` has simple joints. `pairs` are of indices of `bodies`; bodies without a shape are left
  /// out. `ranges` has one per joint that mimics no other one: no motion leaves them. All arguments
  /// but `goal` must outlive this object.
  PathProver(const Robot& robot, const std::vector<PathBody>& bodies, const Pairs& pairs,
             const std::vector<Limits>& ranges, const PathGoal& goal);
  PathProver(PathProver&&) noexcept;
  ~PathProver();

  SegmentProof prove(const JointMotion& motion, const std::function<bool()>& is_over);

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace link_bounds

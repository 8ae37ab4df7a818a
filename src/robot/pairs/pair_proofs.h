// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot can collide while its joints move in their ranges.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "robot/pairs/pair_search.h"

namespace link_bounds {

enum class Verdict {
  kNever,      ///< proven: no pose collides
  kAlways,     ///< proven: every pose collides
  kSometimes,  ///< a pose collides; whether every pose does is not proven
  kUndecided
};

struct PairProof {
  std::size_t first = 0;   ///< index in BoundedRobot::links
  std::size_t second = 0;  ///< stands after `first`
  Verdict verdict = Verdict::kUndecided;
  double clearance = 0;  ///< proven: in no pose the links are nearer [m]
  double nearest = 0;    ///< at most this far are the links apart in `pose` [m]
  /// A pose that collides, or the nearest one that was found: the joints between the links [rad,
  /// m].
  std::map<std::string, double> pose;
  bool has_free_pose = false;  ///< a pose was found that does not collide
  std::string reason;          ///< why nothing is known about the pair; mostly empty
};

struct ProofControl {
  std::function<bool()> is_over = [] { return false; };  ///< any thread calls it
  /// Called with the number of pairs that are decided and of all pairs, by one thread at a time;
  /// may be null.
  std::function<void(std::size_t, std::size_t)> progress = {};
  unsigned threads = 0;  ///< 0: one per core
};

/// All pairs of links with shapes, in their order, but those of one rigid body and neighbours by
/// one joint. `bounded` has bodies, `ranges` has one per joint. A link that is incomplete is in no
/// pair that never collides. Threads only share the work: each pair is searched as it would be
/// alone, until the control says that it is over.
std::vector<PairProof> provePairs(const Robot& robot, const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges, const PairGoal& goal,
                                  const ProofControl& control);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Proofs about a robot that moves along way points among objects that rest.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "robot/pairs/srdf.h"
#include "robot/posed/path_prover.h"

namespace link_bounds {

/// Links in the order of BoundedRobot, then objects.
struct PathBodies {
  std::vector<PathBody> bodies;
  std::vector<std::string> names;
  PathProver::Pairs pairs;
  std::vector<std::pair<std::string, std::string>> incomplete;  ///< names and reasons
};

/// Both have bodies; objects rest in the frame of the root link. Pairs are links that are not
/// joined, and each object with each link that a joint can move, but for those that are exempt.
PathBodies pathBodies(const Robot& robot, const BoundedRobot& bounded, const BoundedRobot& objects,
                      const Exemptions& exempt);

struct PathControl {
  std::function<bool()> is_over;  ///< true: the rest is undecided; called from several threads
  unsigned threads = 1;
  std::function<void(std::size_t done)> progress = [](std::size_t) {};  ///< segments
};

/// Returns one proof per motion. `simple` is the robot of the bodies with simple joints.
std::vector<SegmentProof> provePath(const Robot& simple, const PathBodies& bodies,
                                    const std::vector<JointMotion>& motions, const PathGoal& goal,
                                    const PathControl& control);

}  // namespace link_bounds

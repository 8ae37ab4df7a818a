// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot and the bodies around it, as the input of a proof about the motion of some joints.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "robot/posed/path_prover.h"
#include "world/path/path_trees.h"

namespace link_bounds {

/// Joints that the trajectory does not move rest where tf has them, and so does the root. An object
/// moves with the link that carries it: the link above its frame, or the link to which it is
/// `attached`. All other objects rest. An object that may be in one of two places is two bodies of
/// the same name.
struct PathScene {
  Robot robot;  ///< with simple joints, see withSimpleJoints(); joints that rest are fixed
  std::vector<PathBody> bodies;
  std::vector<std::string> names;  ///< one per body
  /// Pairs for which isPair() holds and whose bodies move relative to each other.
  PathProver::Pairs pairs;
  std::vector<std::string>
      incomplete;       ///< names of bodies in pairs whose geometry or place is unknown
  std::string problem;  ///< why the first of these is incomplete
};

struct PathLimits {
  std::size_t max_pairs;          ///< of bodies
  std::function<bool()> is_over;  ///< returns true when the time is over
};

/// The request for the copy of the scene that pathScene() needs.
BoxRequest pathRequest();

/// `scene` is a copy for pathRequest(), its model has a robot, and `trees` were prepared for it.
/// `joints` are those of plannedJoints(). Throws std::runtime_error, with the remedy, if tf does
/// not give the value of another joint, or if a limit is exceeded.
PathScene pathScene(PastScene& scene, const std::set<std::string>& joints, const PathTrees& trees,
                    const PathLimits& limits);

}  // namespace link_bounds

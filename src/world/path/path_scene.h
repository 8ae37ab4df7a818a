// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot and the bodies around it, as a proof about the motion of some of its joints needs them.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "robot/posed/path_prover.h"
#include "world/path/path_trees.h"

namespace link_bounds {

/// All but these joints rest where tf has them, and so does the root. Objects move with the link
/// that carries them: that below which their frame is, or to which they are `attached`. All others
/// rest. An object that may be in one of two places is two bodies of one name.
struct PathScene {
  Robot robot;  ///< with simple joints; those that rest are fixed
  std::vector<PathBody> bodies;
  std::vector<std::string> names;  ///< of the bodies
  /// Those that the rule of pairs compares, and of which one moves as seen from the other.
  PathProver::Pairs pairs;
  std::vector<std::string> incomplete;  ///< names in pairs whose geometry or place is not known
  std::string problem;                  ///< why the first of them is that
};

struct PathLimits {
  std::size_t max_pairs;          ///< of bodies
  std::function<bool()> is_over;  ///< true: there is no more time
};

/// What a request needs of a scene: see BoxRequest::has_robot_frames.
BoxRequest pathRequest();

/// `scene` was copied for pathRequest(), of a model with a robot, and `trees` prepared for it.
/// `joints` are those of plannedJoints(). Throws std::runtime_error, with the remedy, where tf does
/// not say where another joint is, and where a limit is exceeded.
PathScene pathScene(PastScene& scene, const std::set<std::string>& joints, const PathTrees& trees,
                    const PathLimits& limits);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The answer to a request of ~check_path, segment by segment.
#pragma once

#include <chrono>
#include <functional>

#include "link_bounds/CheckPath.h"
#include "world/path/path_scene.h"
#include "world/path/planned_trajectory.h"

namespace link_bounds {

class PathCheck {
 public:
  /// Throws what pathScene() and PlannedTrajectory throw.
  PathCheck(PastScene& scene, CheckPath::Request& request, const PathTrees& trees,
            const PathLimits& limits);
  PathCheck(const PathCheck&) = delete;
  PathCheck& operator=(const PathCheck&) = delete;

  /// Works for about `budget`, on at least one segment; true when all are done. Once `is_over`,
  /// which is called often, returns true, the remaining segments are undecided.
  bool proceed(std::chrono::nanoseconds budget, const std::function<bool()>& is_over);

  /// To be called once, after proceed() returned true.
  CheckPath::Response take();

 private:
  void proveNext(const std::function<bool()>& is_over);

  const std::set<std::string> joints_;  ///< of the trajectory, see plannedJoints()
  PathScene scene_;
  PlannedTrajectory trajectory_;
  std::vector<Limits> ranges_;  ///< ranges of joint values that no motion leaves
  PathProver prover_;
  CheckPath::Response response_;
  std::size_t undecided_ = 0;
};

}  // namespace link_bounds

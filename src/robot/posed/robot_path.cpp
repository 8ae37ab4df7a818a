// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments are shared among threads; each has a prover of its own.
#include "robot/posed/robot_path.h"

#include <algorithm>

#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/threads/row_threads.h"

namespace link_bounds {
namespace {

/// Segments per thread between two progress reports.
constexpr std::size_t kBlock = 16;

void addBodies(const BoundedRobot& bounded, const std::vector<std::size_t>& links,
               PathBodies& result) {
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    result.bodies.push_back({links[i], bounded.bodies[i], link.isWhole()});
    result.names.push_back(link.name);
    if (!link.isWhole()) result.incomplete.emplace_back(link.name, link.missing);
  }
}

}  // namespace

PathBodies pathBodies(const Robot& robot, const BoundedRobot& bounded, const BoundedRobot& objects,
                      const Exemptions& exempt) {
  PathBodies result;
  addBodies(bounded, bounded.indices, result);
  addBodies(objects, std::vector<std::size_t>(objects.links.size(), robot.root), result);
  const RigidBodies rigid = rigidBodies(robot);
  const std::size_t links = bounded.links.size();
  for (std::size_t i = 0; i < links; ++i) {
    for (std::size_t j = i + 1; j < result.bodies.size(); ++j) {
      const bool is_object = j >= links;
      // An object and a link that never moves are no pair.
      const bool is_pair = is_object ? !areJoined(rigid, bounded.indices[i], robot.root, 0)
                                     : !areJoined(rigid, bounded.indices[i], bounded.indices[j]);
      if (is_pair && !exempt.reasonOf(result.names[i], result.names[j]))
        result.pairs.emplace_back(i, j);
    }
  }
  return result;
}

std::vector<SegmentProof> provePath(const Robot& simple, const PathBodies& bodies,
                                    const std::vector<JointMotion>& motions, const PathGoal& goal,
                                    const PathControl& control) {
  std::vector<SegmentProof> proofs(motions.size());
  if (motions.empty()) return proofs;
  std::vector<Limits> ranges;  // no motion leaves them
  for (const JointMotion& motion : motions)
    ranges = motion.ranges(ranges);
  const auto threads =
      static_cast<unsigned>(std::min<std::size_t>(control.threads, motions.size()));
  std::vector<PathProver> provers;
  for (unsigned i = 0; i < threads; ++i)
    provers.emplace_back(simple, bodies.bodies, bodies.pairs, ranges, goal);
  const auto work = [&](unsigned thread, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      proofs[i] = provers[thread].prove(motions[i], control.is_over);
  };
  for (std::size_t done = 0; done < motions.size();) {
    control.progress(done);
    const std::size_t end = std::min(done + threads * kBlock, motions.size());
    forRows(done, end, threads, 1, work);
    done = end;
  }
  return proofs;
}

}  // namespace link_bounds

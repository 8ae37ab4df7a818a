// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments of a path that touch only for an instant, between any two samples.
#pragma once

#include <cmath>
#include <string>

#include "link_bounds/robot/robot_loader.h"
#include "robot/posed/path_prover.h"
#include "testing/brute_force.h"

namespace link_bounds {

/// A thin plate slides and turns in front of another one.
inline LoadedRobot thinPlates() {
  const std::string plate = "<visual><geometry><box size='1e-5 0.5 0.5'/></geometry></visual>";
  const std::string limit = "<limit lower='-2' upper='2' effort='1' velocity='1'/>";
  const std::string urdf =
      "<robot name='r'><link name='0'>" + plate + "</link><link name='1'/><link name='2'>" + plate +
      "</link><joint name='turn' type='revolute'><parent link='0'/><child link='1'/>"
      "<axis xyz='1 0 0'/>" +
      limit +
      "</joint><joint name='push' type='prismatic'><parent link='1'/><child link='2'/>"
      "<axis xyz='1 0 0'/>" +
      limit + "</joint></robot>";
  Selection selection;
  selection.triangles = true;
  return loadRobot(urdf, {}, selection);
}

struct PlateCounts {
  int found = 0;    ///< segments that were said to collide
  int sampled = 0;  ///< segments in which samples at MoveIt's default step see a contact
};

/// As MoveIt divides a segment: by steps of at most longest_valid_segment_fraction, 0.005, of the
/// sum of all joint ranges, which is 8 here.
inline int sampleSteps(const WayPoint& from, const WayPoint& to) {
  double length = 0;
  for (std::size_t i = 0; i < from.positions.size(); ++i)
    length += std::abs(to.positions[i] - from.positions[i]);
  return static_cast<int>(std::ceil(length / (0.005 * 8)));
}

/// The moving plate goes through the other one, which takes 20 um of the way.
inline PlateCounts crossedPlates(int segments) {
  const LoadedRobot loaded = thinPlates();
  std::vector<PathBody> bodies;
  for (std::size_t i = 0; i < loaded.bounded.links.size(); ++i)
    bodies.push_back({loaded.bounded.indices[i], loaded.bounded.bodies[i]});
  PathProver prover(loaded.robot, bodies, {{0, 1}}, {{-1, 1}, {-1, 1}}, {});
  brute_force::Random random(1);
  PlateCounts counts;
  for (int i = 0; i < segments; ++i) {
    const WayPoint from{{random.uniform(-1, 1), random.uniform(-1, -0.1)}, {}, {}};
    const WayPoint to{{random.uniform(-1, 1), random.uniform(0.1, 1)}, {}, {}};
    const JointMotion motion(from, to);
    const SegmentProof proof = prover.prove(motion, [] { return false; });
    if (proof.verdict == PathVerdict::kCollides) ++counts.found;
    const int steps = sampleSteps(from, to);
    for (int k = 0; k <= steps; ++k) {
      if (std::abs(motion.at(double(k) / steps)[1]) > 1e-5) continue;
      ++counts.sampled;
      break;
    }
  }
  return counts;
}

}  // namespace link_bounds

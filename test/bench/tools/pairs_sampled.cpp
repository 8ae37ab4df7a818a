// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What samples say about the pairs of a robot, as MoveIt's assistant takes them: FILE.urdf POSES
// visual|collision. One line per pair with what was seen: NEVER, ALWAYS or SOMETIMES, first,
// second.
#include <iostream>
#include <random>

#include "bench/common/processes.h"
#include "link_bounds/geometry/distance/body_distance.h"
#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "packages/package_path.h"
#include "robot/urdf/joint_ranges.h"
#include "testing/robot_files.h"

namespace link_bounds::bench {
namespace {

constexpr double kTouch = 1e-7;  // m, as in --pairs

struct SampledPair {
  std::size_t first;
  std::size_t second;
  bool was_free = false;
  bool collided = false;
};

std::vector<SampledPair> pairsOf(const Robot& robot, const BoundedRobot& bounded) {
  const RigidBodies rigid = rigidBodies(robot);
  std::vector<SampledPair> pairs;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    for (std::size_t j = i + 1; j < bounded.links.size(); ++j) {
      if (!areJoined(rigid, bounded.indices[i], bounded.indices[j], 0)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

std::vector<Eigen::Isometry3d> randomPoses(const Robot& robot,
                                           const std::vector<JointRange>& ranges,
                                           std::mt19937_64& random) {
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Joint& joint = robot.joints[i];
    if (!hasValue(joint.motion) || joint.mimic) continue;
    const double share = std::uniform_real_distribution<double>(0, 1)(random);
    values[joint.name] = ranges[i].lower + share * (ranges[i].upper - ranges[i].lower);
  }
  return linkPoses(robot, jointValues(robot, values));
}

/// What was seen of both kinds is not looked at again.
void look(const std::vector<Eigen::Isometry3d>& poses, const BoundedRobot& bounded,
          SampledPair& pair) {
  if (pair.was_free && pair.collided) return;
  const auto at = [&](std::size_t i) { return Eigen::Affine3d(poses[bounded.indices[i]]); };
  const auto distance = bodyDistance(bounded.bodies[pair.first], at(pair.first),
                                     bounded.bodies[pair.second], at(pair.second), {kTouch / 4, 0});
  if (distance) (distance->upper <= kTouch ? pair.collided : pair.was_free) = true;
}

}  // namespace

void samplePairs(const Words& words) {
  const int count = std::stoi(words[1]);
  Selection selection;
  selection.visual = words[2] == "visual";
  selection.collision = !selection.visual;
  selection.triangles = true;
  const auto [robot, bounded] = loadRobot(textOf(words[0]), {rosPackages()}, selection);
  const std::vector<JointRange> ranges = jointRanges(robot);
  std::vector<SampledPair> pairs = pairsOf(robot, bounded);
  std::mt19937_64 random(1);
  for (int i = 0; i < count; ++i) {
    const std::vector<Eigen::Isometry3d> poses = randomPoses(robot, ranges, random);
    for (SampledPair& pair : pairs)
      look(poses, bounded, pair);
  }
  for (const SampledPair& pair : pairs) {
    std::cout << (!pair.collided  ? "NEVER"
                  : pair.was_free ? "SOMETIMES"
                                  : "ALWAYS")
              << '\t' << bounded.links[pair.first].name << '\t' << bounded.links[pair.second].name
              << '\n';
  }
}

}  // namespace link_bounds::bench

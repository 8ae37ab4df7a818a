// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No link ever leaves its reach in random poses: of random arms, and of the robots of
// LINK_BOUNDS_DATA. LINK_BOUNDS_TEST_SAMPLES says how many poses of each of those are taken.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <iostream>
#include <limits>

#include "testing/import_alone.h"
#include "testing/reach_testing.h"
#include "testing/robot_files.h"
#include "testing/sampled_links.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr double kRobotAccuracy = kIsSanitized ? 0.1 : 0.01;  // m

using Model = LoadedRobot;

std::map<std::string, double> randomValues(const Robot& robot,
                                           const std::vector<JointRange>& ranges,
                                           brute_force::Random& random) {
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i].lead.leader != i || !ranges[i].isFree()) continue;
    // Often at a limit, where many extremes are.
    const double part = std::min(std::max(random.uniform(-0.5, 1.5), 0.0), 1.0);
    const double value = ranges[i].lower + part * (ranges[i].upper - ranges[i].lower);
    values[robot.joints[i].name] = std::min(value, ranges[i].upper);
  }
  return values;
}

/// The smallest distance of any box from the faces of its reach [m].
double expectContained(const Model& model, const std::vector<JointRange>& ranges,
                       const std::vector<std::optional<Reach>>& reaches, int poses,
                       brute_force::Random& random) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < poses; ++i) {
    const auto link_poses =
        linkPoses(model.robot, jointValues(model.robot, randomValues(model.robot, ranges, random)));
    for (std::size_t k = 0; k < reaches.size(); ++k) {
      if (!reaches[k]) continue;
      const Aabb box =
          *linkBox(model.bounded.links[k], Eigen::Affine3d(link_poses[model.bounded.indices[k]]));
      for (std::size_t face = 0; face < kFaces; ++face)
        nearest = std::min(nearest, beyond(face, reaches[k]->faces[face].at, faceOf(box, face)));
    }
  }
  EXPECT_GE(nearest, 0);
  return nearest;
}

Joint randomJoint(std::size_t i, brute_force::Random& random) {
  Joint joint;
  joint.name = "j" + std::to_string(i);
  joint.parent = i;
  joint.child = i + 1;
  joint.motion =
      static_cast<Motion>(static_cast<int>(random.uniform(0, 6)) / 3 + (random.sign() > 0 ? 0 : 1));
  joint.parent_from_joint = Eigen::Isometry3d(random.rigid(0.5).matrix());
  joint.axis = random.vector(1).normalized();
  const double lower = random.uniform(-2, 1);
  if (random.uniform(0, 4) > 1 || joint.motion == Motion::kTranslation)
    joint.limits = Limits{lower, lower + random.uniform(0, 3)};
  if (i > 0 && random.uniform(0, 4) > 3) {
    const auto leader = static_cast<int>(random.uniform(0, static_cast<double>(i)));
    joint.mimic = Mimic{"j" + std::to_string(leader), random.uniform(-2, 2), 0.1};
  }
  return joint;
}

Model randomArm(brute_force::Random& random) {
  Model model;
  const auto joints = static_cast<std::size_t>(random.uniform(1, 6));
  for (std::size_t i = 0; i < joints; ++i)
    model.robot.joints.push_back(randomJoint(i, random));
  for (std::size_t i = 0; i <= joints; ++i) {
    model.robot.links.push_back({"l" + std::to_string(i), {}, {}});
    model.bounded.links.push_back(randomLink(random));
    model.bounded.indices.push_back(i);
  }
  return model;
}

TEST(ReachPoses, RandomArmsStayInside) {
  brute_force::Random random(19);
  double nearest = std::numeric_limits<double>::infinity();
  double largest_gap = 0;
  int arms = 0;
  for (int i = 0; i < repetitions(100); ++i) {
    const Model model = randomArm(random);
    std::vector<JointRange> ranges;
    try {
      ranges = jointRanges(model.robot);
    } catch (const JointError&) {
      continue;  // a follower of a joint without limits
    }
    ++arms;
    std::atomic<int> looks{500};  // enough for two rounds of most arms
    const auto reaches =
        reachOf(model.robot, model.bounded, ranges, {0.05, [&] { return looks-- <= 0; }});
    nearest = std::min(nearest, expectContained(model, ranges, reaches, 100, random));
    for (std::size_t k = 0; k < reaches.size(); ++k) {
      expectAttained(model.robot, ranges, model.bounded.links[k], k, *reaches[k]);
      largest_gap = std::max(largest_gap, reaches[k]->maxGap());
    }
  }
  EXPECT_GT(arms, 1);
  std::cout << arms << " arms, a box came within " << nearest << " m of a face; largest gap "
            << largest_gap << " m\n";
}

int samples() {
  const char* const text = std::getenv("LINK_BOUNDS_TEST_SAMPLES");
  return text ? std::atoi(text) : repetitions(300);
}

void checkRobot(const RobotFile& file, const Selection& selection = {}) {
  const Model model = loadedAlone(parseRobot(textOf(file.urdf)), file.package_path, selection);
  const std::vector<JointRange> ranges = jointRanges(model.robot);
  const auto reaches = reachOf(model.robot, model.bounded, ranges, {kRobotAccuracy});
  for (std::size_t k = 0; k < reaches.size(); ++k) {
    const BoundedLink& link = model.bounded.links[k];
    if (!reaches[k]) continue;
    expectAttained(model.robot, ranges, link, model.bounded.indices[k], *reaches[k]);
    EXPECT_LE(reaches[k]->maxGap(), kRobotAccuracy) << link.name;
  }
  brute_force::Random random(7);
  const double nearest = expectContained(model, ranges, reaches, samples(), random);
  std::cout << file.name() << ": " << samples() << " poses of " << reaches.size()
            << " links, a box came within " << nearest << " m of a face; gap of the robot "
            << unionOf(reaches)->maxGap() << " m\n";
}

TEST(ReachPoses, TheDemoRobotStaysInside) {
  checkRobot(demoRobotFile());
}

TEST(ReachPoses, PublicRobotsStayInside) {
  const std::vector<RobotFile> files = publicRobotFiles();
  if (files.empty()) GTEST_SKIP() << "skipped: links of public robots: LINK_BOUNDS_DATA is not set";
  Selection collision;
  collision.visual = false;
  collision.collision = true;
  for (const RobotFile& file : files) {
    checkRobot(file);
    checkRobot(file, collision);
  }
}

}  // namespace
}  // namespace link_bounds

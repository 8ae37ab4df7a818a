// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No random pose of a robot contradicts a verdict. LINK_BOUNDS_TEST_POSES: how many poses.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iostream>

#include "link_bounds/geometry/distance/body_distances.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "testing/brute_force.h"
#include "testing/import_alone.h"
#include "testing/pair_proofs_testing.h"
#include "testing/robot_files.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr int kSlicesPerPose = 100;  ///< of work, for each random pose
constexpr int kMaxSlices = 100000;
constexpr int kSlicesInValley = 1000;

int randomPoses() {
  const char* text = std::getenv("LINK_BOUNDS_TEST_POSES");
  return text ? std::stoi(text) : repetitions(20);
}

Model readModel(const RobotFile& file) {
  return loadedAlone(parseRobot(textOf(file.urdf)), file.package_path, collisionTriangles());
}

/// So many slices of work for all pairs, which does not depend on the speed of the machine.
std::vector<PairProof> proveInSlices(const Model& model, int slices) {
  ProofControl control;
  std::atomic<int> used{0};
  control.is_over = [&] { return ++used > slices; };
  return provePairs(model.robot, model.bounded, jointRanges(model.robot), {}, control,
                    {true, false});
}

/// Values of the joints, also at the ends of their ranges.
std::map<std::string, double> randomValues(const Model& model,
                                           const std::vector<JointRange>& ranges,
                                           brute_force::Random& random) {
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Joint& joint = model.robot.joints[i];
    if (!hasValue(joint.motion) || joint.mimic) continue;
    const double share = std::min(std::max(random.uniform(-0.1, 1.1), 0.0), 1.0);
    const auto& range = ranges[i];
    values[joint.name] = std::min(range.lower + share * (range.upper - range.lower), range.upper);
  }
  return values;
}

/// Checks what the pose can contradict. `distances` has the bodies by their links.
void checkRandomPose(const Model& model, const std::vector<PairProof>& proofs,
                     const std::map<std::string, double>& values, BodyDistances& distances) {
  const auto poses = linkPoses(model.robot, jointValues(model.robot, values));
  const BoundedRobot& bounded = model.bounded;
  for (std::size_t i = 0; i < bounded.links.size(); ++i)
    distances.move(i, Eigen::Affine3d(poses[bounded.indices[i]]));
  for (const PairProof& proof : proofs) {
    const bool is_always = proof.verdict == Verdict::kAlways;
    const bool is_contact = is_always || proof.verdict == Verdict::kTouching;
    if (!is_contact && proof.clearance == 0) continue;
    distances.setGoal({1e-5, is_contact ? 1 : proof.clearance});
    const BodyDistance distance = distances.find(proof.first, proof.second).value();
    const std::string names =
        bounded.links[proof.first].name + " and " + bounded.links[proof.second].name;
    ASSERT_GE(distance.upper, proof.clearance) << names;
    ASSERT_TRUE(!is_always || distance.lower <= kTouch) << names;
    ASSERT_TRUE(!is_contact || distance.lower <= PairGoal().touching) << names;
  }
}

/// The published matrix of the Panda exempts this pair.
void expectThatLinksFiveAndSevenCollide(const Model& model, const std::vector<PairProof>& proofs) {
  const auto& links = model.bounded.links;
  const auto found = std::find_if(proofs.begin(), proofs.end(), [&links](const PairProof& proof) {
    return links[proof.first].name == "panda_link5" && links[proof.second].name == "panda_link7";
  });
  ASSERT_NE(found, proofs.end());
  EXPECT_EQ(found->verdict, Verdict::kSometimes);
}

void checkRobot(const RobotFile& file) {
  SCOPED_TRACE(file.name());
  const Model model = readModel(file);
  const std::vector<PairProof> proofs =
      proveInSlices(model, std::min(kSlicesPerPose * randomPoses(), kMaxSlices));
  // Under a sanitizer the work ends before.
  if (file.name() == "panda" && !kIsSanitized) expectThatLinksFiveAndSevenCollide(model, proofs);
  std::map<Verdict, int> counts;
  for (const PairProof& proof : proofs) {
    ++counts[proof.verdict];
    checkPose(model, proof, {});
  }
  const std::vector<JointRange> ranges = jointRanges(model.robot);
  BodyDistances distances;
  for (std::size_t i = 0; i < model.bounded.bodies.size(); ++i)
    distances.set(i, std::make_shared<const Body>(model.bounded.bodies[i]));
  brute_force::Random random(1);
  const int poses = randomPoses();
  for (int i = 0; i < poses && !testing::Test::HasFatalFailure(); ++i)
    checkRandomPose(model, proofs, randomValues(model, ranges, random), distances);
  std::cout << file.name() << ": " << proofs.size() << " pairs: " << counts[Verdict::kNever]
            << " never, " << counts[Verdict::kAlways] << " always, " << counts[Verdict::kTouching]
            << " touching, " << counts[Verdict::kContactSampled] << " in contact in all samples, "
            << counts[Verdict::kSometimes] << " sometimes, " << counts[Verdict::kUndecided]
            << " undecided; " << poses << " random poses\n";
}

TEST(PairProofsOfRobots, NoRandomPoseOfTheDemoContradictsThem) {
  checkRobot(demoRobotFile());
}

TEST(PairProofsOfRobots, NoRandomPoseOfPublicRobotsContradictsThem) {
  const std::vector<RobotFile> files = publicRobotFiles();
  if (files.empty()) GTEST_SKIP() << "skipped: pairs of public robots: LINK_BOUNDS_DATA is not set";
  for (const RobotFile& file : files) {
    checkRobot(file);
    if (HasFatalFailure()) return;
  }
}

/// The model without all links but two.
void keepTwo(const std::string& first, const std::string& second, BoundedRobot& bounded) {
  BoundedRobot kept;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    if (bounded.links[i].name != first && bounded.links[i].name != second) continue;
    kept.links.push_back(bounded.links[i]);
    kept.indices.push_back(bounded.indices[i]);
    kept.bodies.push_back(bounded.bodies[i]);
  }
  bounded = std::move(kept);
}

/// All other joints rest.
GivenRanges onlyTheRightArm(const Robot& robot) {
  GivenRanges given;
  const std::vector<JointRange> ranges = jointRanges(robot);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Joint& joint = robot.joints[i];
    if (!hasValue(joint.motion) || joint.mimic || joint.name.compare(0, 2, "r_") == 0) continue;
    const double value = std::min(std::max(0.0, ranges[i].lower), ranges[i].upper);
    given[joint.name] = {value, value};
  }
  return given;
}

/// At the end of a valley of the distance: steps along single joints, and random ones, ended 0.1 mm
/// before the wheel.
TEST(PairProofsOfRobots, ASearchFollowsAValleyToItsEnd) {
  const auto folder = robotsFolder();
  if (!folder)
    GTEST_SKIP() << "skipped: a finger and a wheel of the PR2: LINK_BOUNDS_DATA is not set";
  Model model = readModel(robotFile(*folder, "pr2_description/urdf/pr2.urdf"));
  keepTwo("bl_caster_l_wheel_link", "r_gripper_l_finger_link", model.bounded);
  ProofControl control;
  int left = kSlicesInValley;
  control.threads = 1;
  control.is_over = [&] { return --left < 0; };
  const std::vector<PairProof> proofs =
      provePairs(model.robot, model.bounded, jointRanges(model.robot, onlyTheRightArm(model.robot)),
                 {}, control);
  ASSERT_EQ(proofs.size(), 1);
  EXPECT_EQ(proofs.front().verdict, Verdict::kSometimes) << proofs.front().nearest;
  std::cout << kSlicesInValley - left << " slices\n";
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The reach of arms whose answer is known.
#include "robot/reach/reach.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>

#include "testing/reach_testing.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr double kAccuracy = 1e-3;  // m
constexpr double kRadius = 0.1;     // m

/// Of what takes long, as a sanitizer makes it take a hundred times as long [m].
constexpr double kSlowAccuracy = kIsSanitized ? 0.03 : kAccuracy;

struct Given {
  std::string type;
  double lower;
  double upper;
  std::string more = {};
};

std::string jointText(std::size_t i, const std::string& xyz, const std::string& axis,
                      const Given& given) {
  const std::string n = std::to_string(i);
  return "<joint name='j" + n + "' type='" + given.type + "'><parent link='l" + n +
         "'/><child link='l" + std::to_string(i + 1) + "'/><origin xyz='" + xyz + "'/><axis xyz='" +
         axis + "'/><limit lower='" + std::to_string(given.lower) + "' upper='" +
         std::to_string(given.upper) + "' effort='1' velocity='1'/>" + given.more + "</joint>";
}

/// Links l0, l1, ...; joint i is at x = 1 of link i, but the first one at its origin. A ball at x =
/// 1 of the last link is all there is to see.
Robot planarArm(const std::vector<Given>& joints) {
  std::string text = "<robot name='arm'>";
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool is_sliding = joints[i].type == "prismatic";
    text += "<link name='l" + std::to_string(i) + "'/>" +
            jointText(i, i == 0 ? "0 0 0" : "1 0 0", is_sliding ? "1 0 0" : "0 0 1", joints[i]);
  }
  return parseRobot(text + "<link name='l" + std::to_string(joints.size()) +
                    "'><visual><origin xyz='1 0 0'/><geometry><sphere radius='0.1'/></geometry>"
                    "</visual></link></robot>");
}

Reach reachOfArm(const Robot& robot, const GivenRanges& given = {}, double accuracy = kAccuracy) {
  const BoundedRobot bounded = boundedBy(robot);
  const std::vector<JointRange> ranges = jointRanges(robot, given);
  const Reach reach = *reachOf(robot, bounded, ranges, {accuracy}).at(0);
  expectAttained(robot, ranges, bounded.links[0], bounded.indices[0], reach);
  EXPECT_LE(reach.maxGap(), accuracy);
  return reach;
}

/// The ball's centre is in this box, and comes to each of its faces.
void expectReach(const Reach& reach, const Eigen::Vector3d& min, const Eigen::Vector3d& max,
                 double accuracy = kAccuracy) {
  for (std::size_t face = 0; face < kFaces; ++face) {
    const double exact = face < 3 ? min[static_cast<Eigen::Index>(face)] - kRadius
                                  : max[static_cast<Eigen::Index>(face - 3)] + kRadius;
    EXPECT_GE(beyond(face, reach.faces[face].at, exact), -1e-15) << "face " << face;
    EXPECT_LE(beyond(face, reach.faces[face].at, exact), accuracy) << "face " << face;
    EXPECT_NEAR(reach.faces[face].attained, exact, 1e-6) << "face " << face;
  }
}

const Given kTurn{"continuous", 0, 0};

TEST(Reach, PlanarArmsThatTurn) {
  expectReach(reachOfArm(planarArm({kTurn})), {-1, -1, 0}, {1, 1, 0});
  expectReach(reachOfArm(planarArm({kTurn, kTurn})), {-2, -2, 0}, {2, 2, 0});
  expectReach(reachOfArm(planarArm({kTurn, kTurn, kTurn}), {}, kSlowAccuracy), {-3, -3, 0},
              {3, 3, 0}, kSlowAccuracy);
}

TEST(Reach, PlanarArmWithLimits) {
  const Given quarter{"revolute", 0, 1.5};
  const double s = std::sin(1.5), c = std::cos(1.5);
  expectReach(reachOfArm(planarArm({quarter})), {c, 0, 0}, {1, s, 0});
  // Farthest to the left with both joints at their limits, to the top with the second link upright.
  expectReach(reachOfArm(planarArm({quarter, quarter})), {c + std::cos(3), 0, 0}, {2, 1 + s, 0});
  const Given beside{"revolute", 0.5, 0.75};
  expectReach(reachOfArm(planarArm({beside})), {std::cos(0.75), std::sin(0.5), 0},
              {std::cos(0.5), std::sin(0.75), 0});
}

TEST(Reach, PrismaticJoints) {
  const Given slide{"prismatic", -0.25, 0.75};
  expectReach(reachOfArm(planarArm({slide})), {0.75, 0, 0}, {1.75, 0, 0});
  expectReach(reachOfArm(planarArm({kTurn, slide})), {-2.75, -2.75, 0}, {2.75, 2.75, 0});
}

TEST(Reach, AGivenRangeAndAGivenValue) {
  const Robot robot = planarArm({kTurn, kTurn});
  expectReach(reachOfArm(robot, {{"j0", {0.5, 0.5}}}), {std::cos(0.5) - 1, std::sin(0.5) - 1, 0},
              {std::cos(0.5) + 1, std::sin(0.5) + 1, 0});
  const Reach reach = reachOfArm(robot, {{"j0", {0.5, 0.5}}, {"j1", {0, 0.25}}});
  expectReach(reach, {std::cos(0.5) + std::cos(0.75), 2 * std::sin(0.5), 0},
              {2 * std::cos(0.5), std::sin(0.5) + std::sin(0.75), 0});
  EXPECT_EQ(reach.faces[3].pose.at("j0"), 0.5);
}

TEST(Reach, RangesOfNothingAndOfAMillion) {
  const Given still{"revolute", 0, 0};
  expectReach(reachOfArm(planarArm({still, still})), {2, 0, 0}, {2, 0, 0});
  const Given million{"revolute", -1e6, 1e6};
  expectReach(reachOfArm(planarArm({million, million}), {}, kSlowAccuracy), {-2, -2, 0}, {2, 2, 0},
              kSlowAccuracy);
  const Given far_away{"revolute", 1e6 + 1, 1e6 + 1.5};
  const double q = 1e6 + 1;
  expectReach(reachOfArm(planarArm({far_away})), {std::cos(q + 0.5), std::sin(q), 0},
              {std::cos(q), std::sin(q + 0.5), 0});
}

TEST(Reach, AMimicJointIsNotFree) {
  // The second link stays parallel to x.
  const Robot parallel =
      planarArm({{"revolute", 0, 1.5}, {"revolute", -9, 9, "<mimic joint='j0' multiplier='-1'/>"}});
  const double accuracy = kIsSanitized ? 0.1 : 0.01;
  expectReach(reachOfArm(parallel, {}, accuracy), {1 + std::cos(1.5), 0, 0}, {2, std::sin(1.5), 0},
              accuracy);
  // Two slides that cancel, and another one.
  const Robot slides = planarArm({{"prismatic", -1, 1},
                                  {"prismatic", 0, 0.5},
                                  {"prismatic", -9, 9, "<mimic joint='j0' multiplier='-1'/>"}});
  expectReach(reachOfArm(slides, {}, accuracy), {3, 0, 0}, {3.5, 0, 0}, accuracy);
}

TEST(Reach, AMimicJointWhoseLeaderIsElsewhereHasARangeOfItsOwn) {
  const Robot robot = parseRobot(
      "<robot name='r'><link name='l0'/><link name='l1'/><link name='l2'><visual><origin "
      "xyz='1 0 0'/><geometry><sphere radius='0.1'/></geometry></visual></link>" +
      jointText(0, "0 0 0", "0 0 1", {"revolute", -0.25, 0.5}) +
      "<joint name='other' type='revolute'><parent link='l0'/><child link='l2'/><axis xyz='0 0 1'/>"
      "<mimic joint='j0' multiplier='2' offset='0.25'/><limit effort='1' velocity='1'/></joint>"
      "</robot>");
  const Reach reach = reachOfArm(robot);
  expectReach(reach, {std::cos(1.25), std::sin(-0.25), 0}, {1, std::sin(1.25), 0});
  EXPECT_EQ(reach.faces[3].pose.count("other"), 0u);
  EXPECT_NEAR(reach.faces[3].pose.at("j0"), -0.125, 1e-3);
}

TEST(Reach, IsProvenAtAnyTime) {
  const Robot robot = planarArm({kTurn, {"revolute", 0.5, 1}, kTurn});
  const BoundedRobot bounded = boundedBy(robot);
  const std::vector<JointRange> ranges = jointRanges(robot);
  double last_gap = std::numeric_limits<double>::infinity();
  for (const int looks : {0, 10, 100, kIsSanitized ? 300 : 3000}) {
    std::atomic<int> left{looks};
    const ReachGoal goal{1e-4, [&] { return left-- <= 0; }};
    const Reach reach = *reachOf(robot, bounded, ranges, goal).at(0);
    expectAttained(robot, ranges, bounded.links[0], bounded.indices[0], reach);
    EXPECT_LE(reach.maxGap(), last_gap);
    last_gap = reach.maxGap();
    const double radius = std::sqrt(2 + 2 * std::cos(0.5)) + 1 + kRadius;
    EXPECT_GE(reach.faces[3].at, radius - 1e-15);
  }
  EXPECT_LE(last_gap, 0.2);
}

TEST(Reach, OfAVeryLongChainIsRough) {
  const Robot robot = planarArm(std::vector<Given>(3000, {"revolute", -0.5, 0.25}));
  const BoundedRobot bounded = boundedBy(robot);
  const std::vector<JointRange> ranges = jointRanges(robot);
  const Reach reach = *reachOf(robot, bounded, ranges, {kAccuracy}).at(0);
  EXPECT_GE(reach.faces[3].at, 3000 + kRadius);
  EXPECT_LE(reach.faces[3].at, 3002);
  expectAttained(robot, ranges, bounded.links[0], bounded.indices[0], reach);
}

TEST(Reach, OfTheRobotIsTheUnion) {
  const Robot robot = parseRobot(
      "<robot name='r'><link name='l0'><visual><geometry><sphere radius='0.1'/></geometry></visual>"
      "</link><link name='l1'><visual><origin xyz='1 0 0'/><geometry><sphere radius='0.1'/>"
      "</geometry></visual></link>" +
      jointText(0, "0 0 0", "0 0 1", {"revolute", 0, 1.5}) + "</robot>");
  const auto reaches = reachOf(robot, boundedBy(robot), jointRanges(robot), {kAccuracy});
  ASSERT_EQ(reaches.size(), 2u);
  EXPECT_LE(reaches[0]->maxGap(), 1e-12);
  expectReach(*unionOf(reaches), {0, 0, 0}, {1, std::sin(1.5), 0});
  EXPECT_FALSE(unionOf({}));
}

/// Whose reciprocal is not finite.
TEST(Reach, ATinyComponentOfAnAxisLosesNothing) {
  const Robot robot = parseRobot(
      "<robot name='r'><link name='l0'/><link name='l1'/><link name='l2'><visual><origin "
      "xyz='0 0.1 0'/><geometry><sphere radius='0.01'/></geometry></visual></link>" +
      jointText(0, "0 0 0", "0 0 1", {"revolute", -1.5, 1.5}) +
      jointText(1, "0 0 0", "1 0 1e-308", {"revolute", -0.01, 0.01}) + "</robot>");
  for (const double accuracy : {0.01, kSlowAccuracy}) {
    const Reach reach = reachOfArm(robot, {}, accuracy);
    EXPECT_GE(reach.faces[4].at, 0.11);
    for (std::size_t face = 0; face < kFaces; ++face)
      EXPECT_GE(beyond(face, reach.faces[face].at, reach.faces[face].attained), 0) << face;
  }
}

/// What is done before the first look at `stop` takes time in proportion to the joints: with a path
/// of its own for each link, this chain takes minutes.
TEST(Reach, ALongChainIsStoppedAtOnce) {
  constexpr std::size_t kJoints = 20000;
  const auto linkText = [](std::size_t i) {
    return "<link name='l" + std::to_string(i) +
           "'><visual><geometry><sphere radius='0.1'/></geometry></visual></link>";
  };
  std::string text = "<robot name='chain'>";
  for (std::size_t i = 0; i < kJoints; ++i)
    text += linkText(i) + jointText(i, "1 0 0", "0 0 1", {"revolute", -0.5, 0.25});
  const Robot robot = parseRobot(text + linkText(kJoints) + "</robot>");
  const BoundedRobot bounded = boundedBy(robot);
  const auto begin = std::chrono::steady_clock::now();
  ReachGoal goal{kAccuracy};
  goal.stop = [] { return true; };
  const auto reaches = reachOf(robot, bounded, jointRanges(robot), goal);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_TRUE(reaches.back()) << "it has the rough bound";
  EXPECT_LT(passed.count(), 30);
}

TEST(Reach, ALinkWithoutAFiniteBoxHasNone) {
  const Robot robot = parseRobot(
      "<robot name='r'><link name='l'><visual><origin xyz='1.5e308 0 0'/><geometry>"
      "<box size='1e308 1 1'/></geometry></visual></link></robot>");
  EXPECT_FALSE(reachOf(robot, boundedBy(robot), {}, {kAccuracy}).at(0));
}

}  // namespace
}  // namespace link_bounds

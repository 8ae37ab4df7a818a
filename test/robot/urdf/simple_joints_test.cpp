// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Floating and planar joints as chains, against fixed joints whose origin is the same pose.
#include "robot/urdf/simple_joints.h"

#include <gtest/gtest.h>

#include <sstream>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/urdf/joint_ranges.h"
#include "testing/refusal.h"

namespace link_bounds {
namespace {

using Values = std::map<std::string, double>;

constexpr double kChainTolerance = 1e-14;

std::string link(const std::string& name) {
  return "<link name='" + name + "'/>";
}

std::string jointOfType(const std::string& name, const std::string& type, const std::string& parent,
                        const std::string& child, const std::string& more = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + more + "</joint>";
}

std::string originOf(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  std::ostringstream text;
  text.precision(17);
  text << "<origin xyz='" << xyz.transpose() << "' rpy='" << rpy.transpose() << "'/>";
  return text.str();
}

Robot parsed(const std::string& text) {
  return parseRobot("<robot name='r'>" + text + "</robot>");
}

const std::string kOrigin = originOf({1, -2, 0.5}, {0.3, -0.7, 2});

/// Of the last link of a, b, c: b moves on a, c is fixed to b.
Eigen::Isometry3d tipOf(const std::string& joint_of_b, const Values& values = {}) {
  const Robot robot = withSimpleJoints(parsed(link("a") + link("b") + link("c") + joint_of_b +
                                              jointOfType("e", "fixed", "b", "c", kOrigin)));
  return linkPoses(robot, jointValues(robot, values))[2];
}

/// j is fixed, and so is another joint in the place of the values.
Eigen::Isometry3d tipOfFixed(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  const Robot robot = parsed(link("a") + link("m") + link("b") + link("c") +
                             jointOfType("j", "fixed", "a", "m", kOrigin) +
                             jointOfType("k", "fixed", "m", "b", originOf(xyz, rpy)) +
                             jointOfType("e", "fixed", "b", "c", kOrigin));
  return linkPoses(robot, jointValues(robot, {}))[3];
}

void expectNear(const Eigen::Isometry3d& found, const Eigen::Isometry3d& expected) {
  EXPECT_LT((found.matrix() - expected.matrix()).cwiseAbs().maxCoeff(), kChainTolerance);
}

std::string planar(const std::string& axis) {
  return jointOfType("j", "planar", "a", "b", kOrigin + axis);
}

TEST(SimpleJoints, FloatingIsWhatOriginIs) {
  const std::string floating = jointOfType("j", "floating", "a", "b", kOrigin);
  expectNear(tipOf(floating), tipOfFixed({0, 0, 0}, {0, 0, 0}));
  const Values values{{"j.x", 0.1},  {"j.y", -0.2},   {"j.z", 0.3},
                      {"j.roll", 1}, {"j.pitch", -2}, {"j.yaw", 3}};
  expectNear(tipOf(floating, values), tipOfFixed({0.1, -0.2, 0.3}, {1, -2, 3}));
}

TEST(SimpleJoints, PlanarMovesAcrossItsAxis) {
  const Values values{{"j.x", 0.1}, {"j.y", -0.2}, {"j.yaw", 0.7}};
  expectNear(tipOf(planar("<axis xyz='0 0 1'/>"), values), tipOfFixed({0.1, -0.2, 0}, {0, 0, 0.7}));
  expectNear(tipOf(planar("<axis xyz='2 0 0'/>"), values), tipOfFixed({0, 0.1, -0.2}, {0.7, 0, 0}));
  expectNear(tipOf(planar(""), values), tipOfFixed({0, 0.1, -0.2}, {0.7, 0, 0}));
  expectNear(tipOf(planar("<axis xyz='0 1 0'/>"), values), tipOfFixed({-0.2, 0, 0.1}, {0, 0.7, 0}));
  expectNear(tipOf(planar("<axis xyz='0 0 -1'/>"), values),
             tipOfFixed({0.1, 0.2, 0}, {0, 0, -0.7}));
}

TEST(SimpleJoints, ObliquePlane) {
  const Robot robot =
      withSimpleJoints(parsed(link("a") + link("b") + planar("<axis xyz='1 2 -2'/>")));
  ASSERT_EQ(robot.joints.size(), 3U);
  const Eigen::Vector3d x = robot.joints[0].axis, y = robot.joints[1].axis;
  const Eigen::Vector3d normal = robot.joints[2].axis;
  EXPECT_LT((normal - Eigen::Vector3d(1, 2, -2) / 3).norm(), kChainTolerance);
  EXPECT_LT((x.cross(y) - normal).norm(), kChainTolerance);
  EXPECT_NEAR(x.norm(), 1, kChainTolerance);
  EXPECT_NEAR(y.norm(), 1, kChainTolerance);
}

TEST(SimpleJoints, OtherJointsAndLinksStay) {
  const Robot robot =
      parsed(link("a") + link("b") + link("c") + jointOfType("p", "planar", "a", "b") +
             jointOfType("q", "continuous", "b", "c"));
  const Robot simple = withSimpleJoints(robot);
  ASSERT_EQ(simple.joints.size(), 4U);
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    EXPECT_EQ(simple.links[i].name, robot.links[i].name);
  EXPECT_EQ(simple.joints[3].name, "q");
  EXPECT_EQ(simple.joints[2].child, robot.joints[0].child);
}

TEST(SimpleJoints, ANameThatAnotherJointHas) {
  const Robot robot =
      parsed(link("a") + link("b") + link("c") + jointOfType("p", "planar", "a", "b") +
             jointOfType("p.x", "continuous", "b", "c"));
  EXPECT_THROW(withSimpleJoints(robot), JointError);
}

TEST(SimpleJoints, NoJointMimicsSeveralValues) {
  const Robot robot =
      parsed(link("a") + link("b") + link("c") + jointOfType("p", "planar", "a", "b") +
             jointOfType("q", "continuous", "b", "c", "<mimic joint='p'/>"));
  EXPECT_TRUE(robot.warnings.empty());
  EXPECT_EQ(refusalOf<JointError>([&] { leadsOf(withSimpleJoints(robot)); }),
            "joint \"q\" mimics \"p\", which has more than one value; let it "
            "mimic a joint with one value");
}

TEST(SimpleJoints, AMimicElementOfSeveralValuesCausesAWarning) {
  for (const char* type : {"planar", "floating"}) {
    const Robot robot =
        parsed(link("a") + link("b") + link("c") + jointOfType("q", "continuous", "a", "b") +
               jointOfType("p", type, "b", "c", "<mimic joint='q'/>"));
    ASSERT_EQ(robot.warnings.size(), 1U);
    EXPECT_EQ(robot.warnings[0].find("joint \"p\" has a <mimic>, which is left out"), 0U);
  }
}

TEST(SimpleJoints, LengthsAreNotKnownUnlessGivenAndAnglesTakeATurn) {
  const Robot robot = withSimpleJoints(parsed(link("a") + link("b") + planar("")));
  std::vector<JointRange> ranges = jointRanges(robot, {{"j.x", {-1, 2}}});
  EXPECT_TRUE(ranges[0].is_known && !ranges[1].is_known && ranges[2].is_known);
  EXPECT_EQ(ranges[0].lower, -1);
  EXPECT_EQ(ranges[0].upper, 2);
  EXPECT_TRUE(ranges[2].is_full_turn);
  // Of a whole joint, nothing is known either.
  ranges = jointRanges(parsed(link("a") + link("b") + planar("")));
  EXPECT_FALSE(ranges.at(0).is_known);
}

TEST(SimpleJoints, TheBaseIsMovedByJointsOfTheRoot) {
  const Robot robot = withSimpleJoints(
      parsed(link("a") + link("b") + link("c") + link("d") + jointOfType("f", "fixed", "a", "b") +
             jointOfType("p", "planar", "b", "c") + jointOfType("q", "floating", "c", "d")));
  ASSERT_EQ(robot.joints.size(), 10U);
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    EXPECT_EQ(movesBase(robot, i), robot.joints[i].part_of == "p") << robot.joints[i].name;
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of links for joint values, on robots whose poses are computed by hand.
#include "link_bounds/robot/urdf/kinematics.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"
#include "testing/numbers.h"
#include "testing/refusal.h"

namespace link_bounds {
namespace {

using brute_force::turned;

constexpr double kTolerance = 1e-12;

double radians(double degrees) {
  return degrees * M_PI / 180;
}

/// A joint between the links `parent` and `child`.
std::string limitedJoint(const std::string& name, const std::string& type,
                         const std::string& parent, const std::string& child,
                         const std::string& content = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child +
         "'/><limit lower='-0.1' upper='0.1' effort='1' velocity='1'/>" + content + "</joint>";
}

/// Links a, b, c and d in this order.
Robot robotOf(const std::string& joints) {
  return parseRobot(
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>"
      "<link name='d'/>" +
      joints + "</robot>");
}

/// One joint of interest between a and b, the rest fixed to a.
Robot robotWith(const std::string& type, const std::string& content = "") {
  return robotOf(limitedJoint("j", type, "a", "b", content) + limitedJoint("f", "fixed", "a", "c") +
                 limitedJoint("g", "fixed", "a", "d"));
}

using Given = std::map<std::string, double>;

Eigen::Isometry3d poseOf(const Robot& robot, std::size_t link, const Given& given) {
  return linkPoses(robot, jointValues(robot, given)).at(link);
}

void expectPose(const Eigen::Isometry3d& pose, const Eigen::Matrix3d& rotation,
                const Eigen::Vector3d& translation) {
  EXPECT_TRUE(pose.linear().isApprox(rotation, kTolerance)) << pose.matrix();
  EXPECT_LE((pose.translation() - translation).cwiseAbs().maxCoeff(), kTolerance) << pose.matrix();
}

double valueOf(const Robot& robot, const std::string& name, const Given& given) {
  const std::vector<double> values = jointValues(robot, given);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (robot.joints[i].name == name) return values[i];
  }
  return kNan;
}

TEST(LinkPoses, RevoluteAboutATiltedAxisThatIsNoUnitVector) {
  const Robot robot = robotWith("revolute", "<origin xyz='1 2 3'/><axis xyz='2 -4 6'/>");
  for (const double degrees : {30.0, 45.0, 90.0, -30.0}) {
    expectPose(poseOf(robot, 1, {{"j", radians(degrees)}}),
               turned(degrees, Eigen::Vector3d(1, -2, 3)), {1, 2, 3});
  }
}

TEST(LinkPoses, OriginTurnsTheAxis) {
  const Robot robot =
      robotWith("revolute", "<origin rpy='0.5235987755982988 0 0'/><axis xyz='0 0 1'/>");
  expectPose(poseOf(robot, 1, {{"j", radians(45)}}),
             turned(30, Eigen::Vector3d::UnitX()) * turned(45, Eigen::Vector3d::UnitZ()),
             {0, 0, 0});
}

TEST(LinkPoses, ContinuousTurnsAsOftenAsItLikes) {
  const Robot robot = robotWith("continuous", "<axis xyz='0 1 0'/>");
  expectPose(poseOf(robot, 1, {{"j", radians(30 + 3 * 360)}}), turned(30, Eigen::Vector3d::UnitY()),
             {0, 0, 0});
}

TEST(LinkPoses, PrismaticMovesAlongTheNormalisedAxis) {
  const Robot robot = robotWith(
      "prismatic", "<origin xyz='1 0 0' rpy='0 0 0.7853981633974483'/><axis xyz='10 0 0'/>");
  const double half = std::sqrt(0.5);
  expectPose(poseOf(robot, 1, {{"j", 2}}), turned(45, Eigen::Vector3d::UnitZ()),
             {1 + 2 * half, 2 * half, 0});
}

TEST(LinkPoses, LimitsAreNotEnforced) {
  expectPose(poseOf(robotWith("revolute"), 1, {{"j", radians(45)}}),
             turned(45, Eigen::Vector3d::UnitX()), {0, 0, 0});
}

TEST(LinkPoses, FixedFloatingAndPlanarStayAtTheirOrigin) {
  for (const char* type : {"fixed", "floating", "planar"}) {
    SCOPED_TRACE(type);
    const Robot robot = robotWith(type, "<origin xyz='1 2 3' rpy='0 0.5235987755982988 0'/>");
    expectPose(poseOf(robot, 1, {}), turned(30, Eigen::Vector3d::UnitY()), {1, 2, 3});
  }
}

TEST(LinkPoses, JointsAreComposedFromTheRootOutward) {
  const Robot robot =
      robotOf(limitedJoint("j3", "prismatic", "b", "a", "<axis xyz='0 0 1'/>") +
              limitedJoint("j2", "revolute", "c", "b", "<origin xyz='1 0 0'/><axis xyz='0 0 1'/>") +
              limitedJoint("j1", "revolute", "d", "c", "<origin xyz='0 0 1'/><axis xyz='0 1 0'/>"));
  const Given given{{"j1", radians(30)}, {"j2", radians(45)}, {"j3", 0.5}};
  const Eigen::Matrix3d first = turned(30, Eigen::Vector3d::UnitY());
  const Eigen::Matrix3d second = first * turned(45, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d at_b = Eigen::Vector3d(0, 0, 1) + first * Eigen::Vector3d(1, 0, 0);
  expectPose(poseOf(robot, 3, given), Eigen::Matrix3d::Identity(), {0, 0, 0});
  expectPose(poseOf(robot, 2, given), first, {0, 0, 1});
  expectPose(poseOf(robot, 1, given), second, at_b);
  expectPose(poseOf(robot, 0, given), second, at_b + second * Eigen::Vector3d(0, 0, 0.5));
}

TEST(LinkPoses, AZeroAxisIsAnErrorOnlyWhenTheJointMoves) {
  const Robot robot = robotWith("revolute", "<axis xyz='0 0 0'/>");
  EXPECT_NO_THROW(poseOf(robot, 1, {}));
  EXPECT_THROW(poseOf(robot, 1, {{"j", 0.1}}), JointError);
}

TEST(JointValues, AreZeroUnlessGiven) {
  EXPECT_EQ(valueOf(robotWith("revolute"), "j", {}), 0);
  EXPECT_EQ(valueOf(robotWith("revolute"), "j", {{"j", 0.5}}), 0.5);
}

const char kMimicsJ[] = "<mimic joint='j' multiplier='-2' offset='0.25'/>";
const char kMimicsK[] = "<mimic joint='k' multiplier='3' offset='-1'/>";

TEST(JointValues, MimicFollowsWithMultiplierAndOffset) {
  const Robot robot = robotOf(limitedJoint("j", "revolute", "a", "b") +
                              limitedJoint("k", "revolute", "b", "c", kMimicsJ) +
                              limitedJoint("f", "fixed", "c", "d"));
  EXPECT_DOUBLE_EQ(valueOf(robot, "k", {{"j", 0.5}}), -2 * 0.5 + 0.25);
  EXPECT_DOUBLE_EQ(valueOf(robot, "k", {}), 0.25);
}

TEST(JointValues, MimicOfAMimicComposes) {
  // In both orders of the joints.
  for (const bool leader_last : {false, true}) {
    const std::string leader = leader_last ? limitedJoint("j", "revolute", "c", "d")
                                           : limitedJoint("j", "revolute", "a", "b");
    const std::string follower = leader_last ? limitedJoint("l", "revolute", "a", "b", kMimicsK)
                                             : limitedJoint("l", "revolute", "c", "d", kMimicsK);
    const Robot robot =
        robotOf(leader + limitedJoint("k", "revolute", "b", "c", kMimicsJ) + follower);
    EXPECT_DOUBLE_EQ(valueOf(robot, "l", {{"j", 0.5}}), 3 * (-2 * 0.5 + 0.25) - 1);
  }
}

TEST(JointValues, AValueGivenForAMimicDoesNotCount) {
  const Robot robot = robotOf(limitedJoint("j", "revolute", "a", "b") +
                              limitedJoint("k", "revolute", "b", "c", kMimicsJ) +
                              limitedJoint("l", "revolute", "c", "d", kMimicsK));
  EXPECT_DOUBLE_EQ(valueOf(robot, "k", {{"j", 0.5}, {"k", 9}}), -0.75);
  EXPECT_DOUBLE_EQ(valueOf(robot, "l", {{"j", 0.5}, {"k", 9}}), -3.25);
}

TEST(JointValues, RefuseMimicsInACircle) {
  EXPECT_THROW(jointValues(robotOf(limitedJoint("j", "revolute", "a", "b", kMimicsK) +
                                   limitedJoint("k", "revolute", "b", "c", kMimicsJ) +
                                   limitedJoint("f", "fixed", "c", "d")),
                           {}),
               JointError);
  EXPECT_THROW(jointValues(robotWith("revolute", kMimicsJ), {}), JointError) << "mimics itself";
}

TEST(JointValues, RefuseAMimicOfNoJoint) {
  EXPECT_THROW(jointValues(robotWith("revolute", kMimicsK), {}), JointError);
}

TEST(JointValues, RefuseAnUnknownJointByName) {
  const std::string reason = refusalOf<JointError>([] {
    jointValues(robotWith("revolute"), {{"elbow", 1}});
  });
  EXPECT_NE(reason.find("\"elbow\""), std::string::npos) << reason;
}

TEST(JointValues, RefuseAValueForAJointThatCannotMove) {
  for (const char* type : {"fixed", "floating", "planar"}) {
    EXPECT_THROW(jointValues(robotWith(type), {{"j", 0.0}}), JointError) << type;
  }
}

TEST(JointValues, RefuseNumbersThatAreNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_THROW(jointValues(robotWith("revolute"), {{"j", bad}}), JointError);
  }
}

}  // namespace
}  // namespace link_bounds

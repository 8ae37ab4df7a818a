// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where joints can be: limits, full turns, mimic joints, and what is refused.
#include "robot/urdf/joint_ranges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "link_bounds/robot/urdf/kinematics.h"
#include "testing/numbers.h"
#include "testing/refusal.h"

namespace link_bounds {
namespace {

Joint joint(const std::string& name, Motion motion, const std::optional<Limits>& limits) {
  Joint result;
  result.name = name;
  result.motion = motion;
  result.parent_from_joint = Eigen::Isometry3d::Identity();
  result.axis = Eigen::Vector3d::UnitZ();
  result.limits = limits;
  return result;
}

Joint turning(const std::optional<Limits>& limits) {
  return joint("a", Motion::kRotation, limits);
}

Joint sliding(const std::optional<Limits>& limits) {
  return joint("a", Motion::kTranslation, limits);
}

Joint mimicking(const std::string& name, Motion motion, const Mimic& mimic) {
  Joint result = joint(name, motion, Limits{-0.1, 0.1});
  result.mimic = mimic;
  return result;
}

/// A chain of links.
Robot robotOf(std::vector<Joint> joints) {
  Robot robot;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints[i].parent = i;
    joints[i].child = i + 1;
  }
  robot.links.resize(joints.size() + 1);
  robot.joints = std::move(joints);
  return robot;
}

JointRange rangeOf(const Joint& joint, const GivenRanges& given = {}) {
  return jointRanges(robotOf({joint}), given).at(0);
}

void expectRange(const JointRange& range, double lower, double upper) {
  EXPECT_EQ(range.lower, lower);
  EXPECT_EQ(range.upper, upper);
}

void expectRefused(const Robot& robot, const std::string& text, const GivenRanges& given = {}) {
  const std::string reason = refusalOf<JointError>([&] { jointRanges(robot, given); });
  EXPECT_NE(reason.find(text), std::string::npos) << "\"" << reason << "\", not " << text;
}

TEST(JointRanges, AreTheLimits) {
  expectRange(rangeOf(turning(Limits{-0.5, 1.25})), -0.5, 1.25);
  expectRange(rangeOf(sliding(Limits{0.1, 7})), 0.1, 7);
  EXPECT_FALSE(rangeOf(turning(Limits{-3.14, 3.14})).is_full_turn);
  EXPECT_FALSE(rangeOf(sliding(Limits{-99, 99})).is_full_turn);
}

TEST(JointRanges, OneValueIsNotFree) {
  EXPECT_FALSE(rangeOf(turning(Limits{0.5, 0.5})).isFree());
  EXPECT_TRUE(rangeOf(turning(Limits{0.5, 0.6})).isFree());
  EXPECT_FALSE(rangeOf(joint("a", Motion::kNone, std::nullopt)).isFree());
}

TEST(JointRanges, AContinuousJointTakesAFullTurn) {
  expectRange(rangeOf(turning(std::nullopt)), -M_PI, M_PI);
  EXPECT_TRUE(rangeOf(turning(std::nullopt)).is_full_turn);
}

TEST(JointRanges, ATurnOrMoreIsOneTurnWithinTheLimits) {
  for (const Limits& limits :
       {Limits{-1e6, 1e6}, Limits{-M_PI, M_PI}, Limits{0, 2 * M_PI}, Limits{100, 120},
        Limits{-120, -100}, Limits{-kInfinity, kInfinity}}) {
    const JointRange range = rangeOf(turning(limits));
    EXPECT_TRUE(range.is_full_turn);
    EXPECT_GE(range.lower, limits.lower);
    EXPECT_LE(range.upper, limits.upper);
    EXPECT_NEAR(range.upper - range.lower, 2 * M_PI, 1e-13);
  }
  expectRange(rangeOf(turning(Limits{-1e6, 1e6})), -M_PI, M_PI);
  expectRange(rangeOf(sliding(Limits{-1e6, 1e6})), -1e6, 1e6);
}

TEST(JointRanges, AGivenRangeReplacesTheLimits) {
  expectRange(rangeOf(turning(Limits{-1, 1}), {{"a", {-2, 3}}}), -2, 3);
  expectRange(rangeOf(turning(Limits{-1, 1}), {{"a", {0.5, 0.5}}}), 0.5, 0.5);
  expectRange(rangeOf(sliding(std::nullopt), {{"a", {-2, 3}}}), -2, 3);
  expectRange(rangeOf(turning(Limits{kNan, 1}), {{"a", {-2, 2}}}), -2, 2);
}

TEST(JointRanges, AMimicJointFollows) {
  const Robot robot = robotOf({joint("a", Motion::kRotation, Limits{-1, 2}),
                               mimicking("b", Motion::kTranslation, {"a", -2, 0.5}),
                               mimicking("c", Motion::kRotation, {"b", 0.5, 0})});
  const std::vector<JointRange> ranges = jointRanges(robot, {{"a", {-1, 3}}, {"b", {7, 8}}});
  expectRange(ranges[1], -5.5, 2.5);
  expectRange(ranges[2], -2.75, 1.25);
  for (const JointRange& range : ranges)
    EXPECT_EQ(range.lead.leader, 0u);
  EXPECT_EQ(ranges[2].lead.factor, -1);
  EXPECT_EQ(ranges[2].lead.offset, 0.25);
}

TEST(JointRanges, OneTurnStandsForAllWhereFollowersAreThereAgain) {
  const auto rangesWith = [](double multiplier) {
    return jointRanges(robotOf({joint("a", Motion::kRotation, Limits{-50, 50}),
                                mimicking("b", Motion::kRotation, {"a", multiplier, 0})}));
  };
  expectRange(rangesWith(-3)[0], -M_PI, M_PI);
  expectRange(rangesWith(0.5)[0], -50, 50);
}

TEST(JointRanges, AFollowerThatIsElsewhereAfterATurnNeedsLimits) {
  for (const Joint& follower : {mimicking("b", Motion::kRotation, {"a", 0.5, 0}),
                                mimicking("b", Motion::kTranslation, {"a", 1, 0})}) {
    const Robot robot = robotOf({turning(std::nullopt), follower});
    expectRefused(robot, "give it a range, as in a:=-0.5..0.5");
    EXPECT_NO_THROW(jointRanges(robot, {{"a", {-9, 9}}}));
  }
}

TEST(JointRanges, RefuseWhatIsNoRange) {
  expectRefused(robotOf({turning(Limits{kNan, 1})}), "no number");
  expectRefused(robotOf({sliding(Limits{0, kNan})}), "no number");
  expectRefused(robotOf({turning(Limits{1, -1})}), "lower limit of joint \"a\" is above");
  expectRefused(robotOf({sliding(std::nullopt)}), "joint \"a\" has no limits");
  expectRefused(robotOf({sliding(Limits{0, kInfinity})}), "infinite");
  expectRefused(robotOf({turning(Limits{kInfinity, kInfinity})}), "infinite");
  const Robot robot = robotOf({turning(Limits{-1, 1})});
  expectRefused(robot, "range given for joint \"a\"", {{"a", {1, 0}}});
  expectRefused(robot, "range given for joint \"a\"", {{"a", {kNan, 0}}});
  expectRefused(robot, "\"b\" is no movable joint", {{"b", {0, 1}}});
  expectRefused(robotOf({mimicking("a", Motion::kRotation, {"a", 1, 0})}), "circle");
  Joint flat = turning(Limits{-1, 1});
  flat.axis.setZero();
  expectRefused(robotOf({flat}), "axis is zero");
  EXPECT_NO_THROW(jointRanges(robotOf({flat}), {{"a", {0, 0}}}));
}

}  // namespace
}  // namespace link_bounds

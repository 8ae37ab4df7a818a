// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No two bodies touch before the time that was said; robots whose times are known.
#include "world/stopping/contact_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "testing/contact_times_testing.h"

namespace link_bounds {
namespace {

constexpr char kLimit[] = R"(<limit lower="-3" upper="3" effort="1" velocity="0.5"/>)";

/// Two carts on one rail along x, with spheres of radius 0.1 m.
std::string carts(const std::string& limit = kLimit) {
  const std::string along = R"(<axis xyz="1 0 0"/>)" + limit;
  return "<robot name=\"carts\"><link name=\"rail\"/>" + sphere("left", 0.1) +
         sphere("right", 0.1) + joint("prismatic", "rail", "left", along) +
         joint("prismatic", "rail", "right", along) + "</robot>";
}

/// 1 m apart, each at 0.5 m/s.
TEST(ContactTimes, AreExactForSlides) {
  MovingRobot robot(carts(), parametersOf("rail", 2));
  stand(robot, {0, 1.2});
  const EarliestContactArray array = robot.earliest();
  ASSERT_EQ(array.contacts.size(), 1u);
  EXPECT_EQ(array.contacts[0].first, "left");
  EXPECT_EQ(array.contacts[0].second, "right");
  EXPECT_NEAR(array.contacts[0].distance, 1.0, 1e-4);
  EXPECT_LE(array.contacts[0].earliest.toSec(), kStamp + 1.0);
  EXPECT_NEAR(array.contacts[0].earliest.toSec(), kStamp + 1.0, 1e-3);
  EXPECT_EQ(array.valid_until, array.contacts[0].earliest);
  EXPECT_TRUE(array.incomplete.empty());
}

/// tf2 has such an edge at its newest pose at all times, as if it stood.
TEST(ContactTimes, AStaticJointThatMovesOnTfIsIncomplete) {
  MovingRobot latched(carts(), parametersOf("rail", 2));
  const auto place = [&](double x, bool is_static, double now = kStamp) {
    latched.tf().add({edge("rail", "left", kStamp, Eigen::Quaterniond::Identity(), {x, 0, 0})},
                     is_static, ros::Time(now));
  };
  place(0, true);
  stand(latched, {0, 1.2});
  EXPECT_TRUE(latched.earliest().incomplete.empty()) << "the same pose on /tf";
  place(0.1, false);
  EXPECT_EQ(latched.earliest().incomplete, std::vector<std::string>{"left"});
  EXPECT_EQ(latched.incomplete(), (std::vector<std::string>{"left", "right"}))
      << "right has no deceleration";
  MovingRobot still(carts(), [] {
    Parameters parameters = parametersOf("rail", 2);
    parameters.deceleration = {{"to_left", 1.0}, {"to_right", 1.0}};
    return parameters;
  }());
  for (const double x : {0.0, 0.1}) {
    still.tf().add({edge("rail", "left", kStamp, Eigen::Quaterniond::Identity(), {x, 0, 0})},
                   x == 0, ros::Time(kStamp));
  }
  stand(still, {0.1, 1.2});
  EXPECT_EQ(still.incomplete(), std::vector<std::string>{"left"}) << "all of its way is static";
  place(0.1, true, kStamp + 9);
  EXPECT_EQ(latched.earliest().incomplete, std::vector<std::string>{"left"}) << "/tf may go on";
  place(0.1, true, kStamp + 11);
  EXPECT_TRUE(latched.earliest().incomplete.empty()) << "/tf_static decides again";
}

/// All is on /tf_static, so the boxes have no stamp.
TEST(ContactTimes, WithoutAStampTenSecondsCountFromTheClock) {
  MovingRobot robot(carts(), parametersOf("rail", 2));
  for (const auto& [link, x] : {std::pair("left", 0.0), std::pair("right", 1.2)}) {
    robot.tf().add({edge("rail", link, 0, Eigen::Quaterniond::Identity(), {x, 0, 0})}, true,
                   ros::Time(kStamp));
  }
  robot.scene().update(ros::Time(kStamp));
  const EarliestContactArray array = robot.earliest(kStamp + 1);
  EXPECT_TRUE(array.header.stamp.isZero());
  EXPECT_EQ(array.valid_until, ros::Time(kStamp + 11));
  EXPECT_TRUE(array.incomplete.empty());
}

/// A pose that is known is not of the future.
TEST(ContactTimes, AStampAheadOfTheClockDelaysNothing) {
  MovingRobot robot(carts(), parametersOf("rail", 2));
  stand(robot, {0, 1.2});
  for (const double ahead : {0.3, 5.0}) {
    const EarliestContactArray array = robot.earliest(kStamp - ahead);
    EXPECT_LE(untilOf(array), kStamp - ahead + 1.0);
    EXPECT_GE(untilOf(array), kStamp - ahead + 0.99);
  }
  // What came at kStamp is not of later.
  for (const char* cart : {"left", "right"})
    robot.add("rail", cart, kStamp + 0.9,
              Eigen::Isometry3d(Eigen::Translation3d(cart == std::string("left") ? 0 : 1.2, 0, 0)));
  EXPECT_LE(untilOf(robot.earliest(kStamp + 1)), kStamp + 1.0);
  EXPECT_GE(untilOf(robot.earliest(kStamp + 1)), kStamp + 0.99);
}

/// left is on a truck whose driver has a clock that is ahead: at its stamp the truck was where it
/// was that long before.
TEST(ContactTimes, AClockAheadOnTheWayDelaysNothing) {
  const std::string along = std::string(R"(<axis xyz="1 0 0"/>)") + kLimit;
  const std::string urdf = "<robot name=\"truck\"><link name=\"rail\"/><link name=\"truck\"/>" +
                           sphere("left", 0.1) + sphere("right", 0.1) +
                           joint("prismatic", "rail", "truck", along) +
                           joint("prismatic", "truck", "left", along) +
                           joint("prismatic", "rail", "right", along) + "</robot>";
  for (const double ahead : {0.0, 0.3, 0.9}) {
    MovingRobot robot(urdf, parametersOf("rail", 2));
    stand(robot, {0, 0, 1.2});
    robot.add("rail", "truck", kStamp + ahead, Eigen::Isometry3d::Identity());
    const double touch = kStamp + (1.0 - ahead) / 1.5;  // until kStamp truck and left move alone
    const EarliestContactArray array = robot.earliest();
    ASSERT_TRUE(array.incomplete.empty());
    EXPECT_LE(untilOf(array), touch);
    EXPECT_GE(untilOf(array), touch - 0.01);
  }
}

/// As robot_state_publisher dates fixed joints on /tf, half a second ahead.
TEST(ContactTimes, AFixedJointThatIsDatedAheadBringsNothingForward) {
  const std::string along = std::string(R"(<axis xyz="1 0 0"/>)") + kLimit;
  MovingRobot robot("<robot name=\"plate\"><link name=\"rail\"/><link name=\"plate\"/>" +
                        sphere("left", 0.1) + sphere("right", 0.1) +
                        joint("fixed", "rail", "plate", "") +
                        joint("prismatic", "plate", "left", along) +
                        joint("prismatic", "rail", "right", along) + "</robot>",
                    parametersOf("rail", 2));
  stand(robot, {0, 0, 1.2});
  robot.add("rail", "plate", kStamp + 0.5, Eigen::Isometry3d::Identity());
  const EarliestContactArray array = robot.earliest();
  ASSERT_TRUE(array.incomplete.empty());
  EXPECT_LE(untilOf(array), kStamp + 1.0);
  EXPECT_GE(untilOf(array), kStamp + 0.99);
}

/// A localisation dates map -> odom ahead. The fixed frame is odom.
TEST(ContactTimes, WhatIsDatedAheadAboveTheFixedFrameBringsNothingForward) {
  for (const double ahead : {0.0, 0.5}) {
    MovingRobot robot(carts(), parametersOf("odom", 2));
    for (int i = 20; i >= 0; --i) {
      robot.add("map", "odom", kStamp + ahead - 0.01 * i,
                Eigen::Isometry3d(Eigen::Translation3d(0.01 * i, 0, 0)));
      for (const auto& [cart, x] : std::map<std::string, double>{{"left", 0}, {"right", 3}})
        robot.add("rail", cart, kStamp - 0.01 * i,
                  Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0)));
    }
    robot.tf().add({edge("odom", "rail", kStamp, Eigen::Quaterniond::Identity(), {0, 0, 0})}, true,
                   ros::Time(kStamp));
    ObjectContent content;
    content.bounded.name = "post/0";
    content.bounded.shapes = {{nullptr, Solid::kBox, {0.2, 0.2, 0.2}, Eigen::Affine3d::Identity()}};
    content.bounded.shapes[0].link_from_shape.translation().x() = -1.2;
    content.frame = "odom";
    robot.scene().objects.put({"post", 0}, content, ros::Time(kStamp));
    robot.scene().update(ros::Time(kStamp));
    const EarliestContactArray array = robot.earliest();
    EXPECT_TRUE(array.incomplete.empty());
    EXPECT_GE(untilOf(array), kStamp + 1.99) << "left is 1 m from the post, at 0.5 m/s";
    EXPECT_LE(untilOf(array), kStamp + 2.0);
  }
}

/// A sphere on an arm of 1 m turns by a quarter at 0.5 rad/s until it touches, less what both
/// spheres take.
TEST(ContactTimes, AreNearTheTruthForATurn) {
  const std::string at_end = R"(<origin xyz="0 1 0"/>)";
  MovingRobot robot(
      "<robot name=\"arm\"><link name=\"base\"/><link name=\"arm\"/>" + sphere("goal", 0.1) +
          sphere("tip", 0.1) + joint("fixed", "base", "goal", at_end) +
          joint("revolute", "base", "arm", "<axis xyz=\"0 0 1\"/>" + std::string(kLimit)) +
          joint("fixed", "arm", "tip", at_end) + "</robot>",
      [] {
        Parameters parameters = parametersOf("base", 2);
        parameters.adjacent_joints = 0;
        return parameters;
      }());
  stand(robot, robot.values({{"to_arm", -M_PI / 2}}));
  const double truth = (M_PI / 2 - 2 * std::asin(0.1)) / 0.5;
  EXPECT_LE(untilOf(robot.earliest()), kStamp + truth);
  EXPECT_GE(untilOf(robot.earliest()), kStamp + 0.8 * truth);
}

/// Beyond distance_limit the boxes are what is known.
TEST(ContactTimes, WhatIsNotListedCounts) {
  MovingRobot robot(carts(), parametersOf("rail", 0.01));
  stand(robot, {0, 1.2});
  const EarliestContactArray array = robot.earliest();
  ASSERT_EQ(array.contacts.size(), 1u);
  EXPECT_NEAR(untilOf(array), kStamp + 1.0, 1e-3);
  EXPECT_LE(untilOf(array), kStamp + 1.0);
}

/// From rest at 2 m/s^2 up to 0.5 m/s: 0.25 s and 0.0625 m until then.
TEST(ContactTimes, AccelerationDelays) {
  Parameters parameters = parametersOf("rail", 2);
  parameters.acceleration = {{"to_left", 2}, {"to_right", 2}};
  MovingRobot robot(carts(), parameters);
  stand(robot, {0, 1.2});
  const double exact = kStamp + 0.25 + (1.0 - 2 * 0.0625) / (2 * 0.5);
  EXPECT_LE(untilOf(robot.earliest()), exact);
  EXPECT_NEAR(untilOf(robot.earliest()), exact, 0.02);  // tf proves no rest, but slow motion
}

TEST(ContactTimes, JointLimitsHoldBodiesApart) {
  const std::string narrow = R"(<limit lower="-0.1" upper="1.3" effort="1" velocity="0.5"/>)";
  MovingRobot robot(carts(narrow), parametersOf("rail", 2));
  stand(robot, {0, 1.2});
  EXPECT_NEAR(untilOf(robot.earliest()), kStamp + 1.0, 1e-3);
  const std::string apart = R"(<limit lower="-0.1" upper="0.2" effort="1" velocity="0.5"/>)";
  MovingRobot other(carts(apart), parametersOf("rail", 2));
  stand(other, {0, 0.2});
  EXPECT_LE(untilOf(other.earliest()), kStamp + 1e-3);  // they touch already
}

TEST(ContactTimes, WithoutAVelocityLimitIsIncomplete) {
  const std::string none = R"(<limit lower="-3" upper="3" effort="1" velocity="0"/>)";
  MovingRobot robot(carts(none), parametersOf("rail", 2));
  stand(robot, {0, 1.2});
  EXPECT_EQ(robot.earliest().incomplete, (std::vector<std::string>{"left", "right"}));
  EXPECT_TRUE(robot.earliest().contacts.empty());
}

/// A mast that may turn fast carries both spheres; only the joint of one of them counts.
TEST(ContactTimes, JointsBelowBothBodiesDoNotCount) {
  const std::string fast = R"(<limit lower="-3" upper="3" effort="1" velocity="20"/>)";
  MovingRobot robot(
      "<robot name=\"mast\"><link name=\"base\"/><link name=\"mast\"/>" + sphere("fixed", 0.1) +
          sphere("cart", 0.1) + joint("revolute", "base", "mast", "<axis xyz=\"0 0 1\"/>" + fast) +
          joint("fixed", "mast", "fixed", "<origin xyz=\"1 0 0\"/>") +
          joint("prismatic", "mast", "cart", "<axis xyz=\"1 0 0\"/>" + std::string(kLimit)) +
          "</robot>",
      [] {
        Parameters parameters = parametersOf("base", 2);
        parameters.adjacent_joints = 0;
        return parameters;
      }());
  stand(robot, robot.values({{"to_cart", 0.3}}));
  EXPECT_NEAR(untilOf(robot.earliest()), kStamp + 0.5 / 0.5, 1e-3);
}

TEST(ContactTimes, WhatHasNoPoseEndsAllValidity) {
  MovingRobot robot(carts(), parametersOf("rail", 2));
  EXPECT_TRUE(robot.earliest().valid_until.isZero());
  stand(robot, {0, 1.2});
  EXPECT_FALSE(robot.earliest().valid_until.isZero());
  robot.scene().update(ros::Time(kStamp + 3));
  EXPECT_TRUE(robot.earliest(kStamp + 3).valid_until.isZero());  // stale
}

TEST(ContactTimes, WithoutALinkNothingIsValid) {
  Parameters parameters = parametersOf("rail", 2);
  parameters.links = {"no_such_link"};
  MovingRobot robot(carts(), parameters);
  stand(robot, {0, 1.2});
  EXPECT_TRUE(robot.earliest().valid_until.isZero());
}

using Names = std::vector<std::string>;

/// A box that reaches from x = 1.5 m on, in front of the right cart.
void putBox(MovingRobot& robot, const std::string& frame, const std::string& name = "scene/1") {
  ObjectContent content;
  content.bounded.name = name;
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  place.translation().x() = 2;
  content.bounded.shapes = {{nullptr, Solid::kBox, {1, 1, 1}, place}};
  content.frame = frame;
  robot.scene().objects.put({"scene", 1}, content, ros::Time(kStamp));
  robot.scene().update(ros::Time(kStamp));
}

TEST(ContactTimes, WhatStandsIsReachedByTheRobotAlone) {
  MovingRobot robot(carts(), parametersOf("rail", 2));
  stand(robot, {0, 1.2});
  putBox(robot, "rail");
  const EarliestContactArray array = robot.earliest();
  EXPECT_EQ(array.incomplete, Names());
  ASSERT_EQ(array.contacts.size(), 3u);
  EXPECT_EQ(array.contacts[0].second, "scene/1");
  EXPECT_NEAR(untilOf(array), kStamp + 0.2 / 0.5, 1e-3);
}

TEST(ContactTimes, AnObjectMayHaveTheNameOfALink) {
  for (const double limit : {2.0, 0.1}) {
    MovingRobot robot(carts(), parametersOf("rail", limit));
    stand(robot, {0, 1.2});
    putBox(robot, "rail", "left");
    const EarliestContactArray array = robot.earliest();
    ASSERT_FALSE(array.contacts.empty());
    EXPECT_NEAR(array.contacts[0].distance, 0.2, 1e-4);
    EXPECT_NEAR(untilOf(array), kStamp + 0.2 / 0.5, 1e-3) << "the right cart moves alone";
  }
}

/// Nobody says how fast a base is. Links of one robot do not care.
TEST(ContactTimes, ABaseThatMayMoveLeavesObjectsIncomplete) {
  for (const char* fixed_frame : {"map", "rail"}) {
    MovingRobot robot(carts(), parametersOf(fixed_frame, 2));
    stand(robot, {0, 1.2});
    putBox(robot, "map");
    const EarliestContactArray array = robot.earliest();
    EXPECT_NEAR(untilOf(array), kStamp + 1.0, 1e-3);
    EXPECT_EQ(array.incomplete, Names{"scene/1"});
  }
}

Eigen::Isometry3d at(double x, double y = 0) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0));
}

/// The way of the base between the two stamps is no distance between the carts.
TEST(ContactTimes, ABaseThatDrivesChangesNothingBetweenLinks) {
  for (const char* fixed_frame : {"rail", "map"}) {
    MovingRobot robot(carts(), parametersOf(fixed_frame));
    for (int i = 100; i >= 0; --i) {
      const double ago = 0.01 * i;
      robot.add("map", "rail", kStamp - ago, at(-ago));
      robot.add("rail", "right", kStamp - ago, at(0.4));
      if (i >= 10) robot.add("rail", "left", kStamp - ago, at(0));
    }
    robot.scene().update(ros::Time(kStamp));
    const EarliestContactArray array = robot.earliest();
    ASSERT_EQ(array.contacts.size(), 1u);
    EXPECT_NEAR(array.contacts[0].distance, 0.2, 1e-4) << fixed_frame;
    // The left one from 0.1 s before the stamp on, the right one from the stamp on.
    EXPECT_NEAR(untilOf(array), kStamp + 0.15, 1e-3) << fixed_frame;
    EXPECT_LE(untilOf(array), kStamp + 0.15) << fixed_frame;
  }
}

/// However rarely it is sent.
TEST(ContactTimes, AFixedJointThatMovesIsTold) {
  const std::string fixed = R"(<joint name="f" type="fixed"><parent link="rail"/>)";
  for (const double speed : {0.0, 0.1}) {
    for (const double period : {0.01, 0.2}) {
      MovingRobot robot("<robot name=\"r\"><link name=\"rail\"/>" + sphere("camera", 0.1) + fixed +
                            R"(<child link="camera"/></joint></robot>)",
                        parametersOf("rail"));
      for (int i = 5; i >= 0; --i)
        robot.add("rail", "camera", kStamp - period * i, at(-speed * period * i));
      robot.scene().update(ros::Time(kStamp));
      EXPECT_EQ(robot.earliest().incomplete, speed > 0 ? Names{"camera"} : Names()) << period;
    }
  }
}

/// Of these only the pair that touches first is measured, and its stamp is the older one.
TEST(ContactTimes, APairThatWasNotMeasuredDelaysNothing) {
  const std::string along = std::string(R"(<axis xyz="1 0 0"/>)") + kLimit;
  Parameters parameters = parametersOf("rail", 0.1);
  parameters.max_pairs = 1;
  parameters.adjacent_joints = 0;
  MovingRobot robot("<robot name=\"r\"><link name=\"rail\"/>" + sphere("early", 0.1) +
                        sphere("post", 0.1) + sphere("c", 0.1) + sphere("d", 0.1) +
                        joint("fixed", "rail", "post", R"(<origin xyz="0.25 0 0"/>)") +
                        joint("prismatic", "rail", "early", along) +
                        joint("prismatic", "rail", "c", R"(<origin xyz="0 5 0"/>)" + along) +
                        joint("prismatic", "rail", "d", R"(<origin xyz="0 5.19 0"/>)" + along) +
                        "</robot>",
                    parameters);
  for (int i = 100; i >= 0; --i) {
    const double stamp = kStamp - 0.01 * i;
    robot.add("rail", "post", stamp, at(0.25));
    if (i >= 50) robot.add("rail", "early", stamp, at(0));
    robot.add("rail", "c", stamp, at(0, 5));
    robot.add("rail", "d", stamp, at(0.19, 5.19));
  }
  robot.scene().update(ros::Time(kStamp));
  const EarliestContactArray array = robot.earliest();
  EXPECT_EQ(array.incomplete, (Names{"c", "d"}));
  ASSERT_FALSE(array.contacts.empty());
  EXPECT_LE(array.valid_until, array.contacts[0].earliest);
  EXPECT_LE(untilOf(array), kStamp - 0.5 + 0.1);
}

/// An arm slides by 0.5 m and rests; what it holds meets a wall 0.4 m later.
EarliestContactArray earliestHeld(const std::string& frame, double x, double placed,
                                  std::optional<double> map_behind = {}, bool follows = false) {
  const std::string along =
      R"(<axis xyz="1 0 0"/><limit lower="0" upper="1" effort="1" velocity="1"/>)";
  const std::string far_arm =
      R"(<link name="arm"><visual><origin xyz="0 5 0"/><geometry><sphere radius="0.1"/></geometry>
      </visual></link>)";
  Parameters parameters = parametersOf("rail", 2);
  parameters.attached["arm"] = {"held/*"};
  parameters.adjacent_joints = 0;
  MovingRobot robot("<robot name=\"r\"><link name=\"rail\"/>" + far_arm + sphere("wall", 0.1) +
                        joint("fixed", "rail", "wall", R"(<origin xyz="2.1 0 0"/>)") +
                        joint("prismatic", "rail", "arm", along) + "</robot>",
                    parameters);
  for (int i = 100; i >= 0; --i) {
    const double stamp = kStamp - 0.01 * i;
    if (map_behind) robot.add("map", "rail", stamp - *map_behind, at(0));
    robot.add("rail", "wall", stamp, at(2.1));
    robot.add("rail", "arm", stamp, at(std::min(0.5, 1 - 0.01 * i)));
    robot.scene().update(ros::Time(stamp));
    if (std::abs(stamp - placed) > 1e-6) continue;
    ObjectContent content;
    content.bounded.name = "held/1";
    content.bounded.shapes = {
        {nullptr, Solid::kEllipsoid, {0.2, 0.2, 0.2}, Eigen::Affine3d(at(x).matrix())}};
    content.frame = frame;
    content.stamp = frame == "arm" || follows ? 0 : std::llround(stamp * 1e9);
    robot.scene().objects.put({"held", 1}, content, ros::Time(stamp));
  }
  robot.scene().update(ros::Time(kStamp));
  return robot.earliest();
}

/// Its box is of one time, the joints of its link are of another.
TEST(ContactTimes, WhatIsHeldMovesWithTheNewestOfItsLink) {
  const EarliestContactArray following = earliestHeld("arm", 1, kStamp);
  EXPECT_EQ(following.incomplete, Names());
  EXPECT_NEAR(untilOf(following), kStamp + 0.4, 1e-3);
  const EarliestContactArray placed = earliestHeld("rail", 1.5, kStamp);
  EXPECT_EQ(placed.incomplete, Names());
  EXPECT_NEAR(untilOf(placed), kStamp + 0.4, 1e-3);
  EXPECT_EQ(earliestHeld("rail", 1, kStamp - 1).incomplete, Names{"held/1"});
  // What is above the fixed frame does not count.
  for (const double map_behind : {0.0, 0.005}) {
    EXPECT_EQ(earliestHeld("rail", 1.5, kStamp, map_behind).incomplete, Names());
    EXPECT_EQ(earliestHeld("rail", 1, kStamp - 1, map_behind).incomplete, Names{"held/1"});
  }
}

/// It may leave the link to which it is attached.
TEST(ContactTimes, WhatIsHeldByOneLinkAndFollowsAnotherIsIncomplete) {
  EXPECT_EQ(earliestHeld("wall", -0.6, kStamp, {}, true).incomplete, Names{"held/1"});
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From transforms to stopping boxes: which stops the boxes cover, and what makes a link incomplete.
#include "world/stopping/stopping_boxes.h"

#include <gtest/gtest.h>

#include "testing/moving_robot.h"

namespace link_bounds {
namespace {

constexpr double kRate = MovingRobot::kRate;
constexpr double kStamp = MovingRobot::kStamp;
constexpr double kDeceleration = 4;

/// An arm of all joint types that have a value, on a base that may drive.
constexpr char kArm[] = R"(<robot name="arm">
  <link name="base"><visual><geometry><box size="0.4 0.3 0.2"/></geometry></visual></link>
  <link name="upper">
    <visual><origin xyz="0.3 0 0"/><geometry><sphere radius="0.08"/></geometry></visual>
  </link>
  <link name="fore">
    <visual><origin xyz="0.2 0.05 0"/><geometry><box size="0.4 0.1 0.05"/></geometry></visual>
  </link>
  <link name="hand"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
  <link name="left"><visual><geometry><sphere radius="0.02"/></geometry></visual></link>
  <link name="right"><visual><geometry><sphere radius="0.02"/></geometry></visual></link>
  <joint name="pan" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0.1 0 0.2" rpy="0.1 0.2 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="2"/></joint>
  <joint name="roll" type="continuous"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.5 0 0" rpy="0 0 0.4"/><axis xyz="0 -1 0"/></joint>
  <joint name="flange" type="fixed"><parent link="fore"/><child link="hand"/>
    <origin xyz="0.4 0 0"/></joint>
  <joint name="finger" type="prismatic"><parent link="hand"/><child link="left"/>
    <origin xyz="0.05 0.02 0"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.05" effort="1" velocity="0.1"/></joint>
  <joint name="other" type="prismatic"><parent link="hand"/><child link="right"/>
    <origin xyz="0.05 -0.02 0"/><axis xyz="0 -1 0"/><mimic joint="finger"/>
    <limit lower="0" upper="0.05" effort="1" velocity="0.1"/></joint>
</robot>)";

using Values = MovingRobot::Values;

Parameters goodParameters() {
  Parameters parameters;
  parameters.fixed_frame = "map";
  for (const char* joint : {"pan", "roll", "finger"})
    parameters.deceleration[joint] = kDeceleration;
  parameters.base_deceleration = {{"linear", 1.0}, {"angular", 1.0}};
  return parameters;
}

struct Robotics : MovingRobot {
  explicit Robotics(const Parameters& parameters) : MovingRobot(kArm, parameters) {}
};

bool contains(const Moment& moment, const std::map<std::string, Aabb>& boxes) {
  constexpr double kRounding = 1e-12;  // of tf's quaternions
  for (const Moment::Body& body : moment.bodies) {
    const Aabb& box = boxes.at(moment.name(body));
    if (!padded(body.box, kRounding).contains(box)) return false;
  }
  return true;
}

using Names = std::vector<std::string>;

/// The worst stop that the parameters allow: all joints brake as late and as softly as they may.
bool coversWorstStop(double longer, std::uint64_t seed) {
  brute_force::Random random(seed);
  Robotics robot(goodParameters());
  const double pan_speed = random.uniform(-1.5, 1.5);
  const double roll_speed = random.uniform(-2.5, 2.5);
  const Values start = robot.values(
      {{"pan", random.uniform(-0.2, 0.2)}, {"roll", random.uniform(-10, 10)}, {"finger", 0.02}});
  const Values speeds = robot.values({{"pan", pan_speed}, {"roll", roll_speed}});
  robot.move(start, speeds);
  const WayBoxes found = robot.stopping();
  EXPECT_EQ(found.problem, "");
  EXPECT_EQ(found.moment->bodies.size(), robot.robot().links.size());
  bool covers = true;
  for (int i = 0; i <= 100; ++i) {
    Values values = start;
    for (std::size_t j = 0; j < values.size(); ++j) {
      const double way =
          std::abs(speeds[j]) * 0.1 + speeds[j] * speeds[j] / (2 * kDeceleration) * longer;
      values[j] += (speeds[j] < 0 ? -way : way) * i / 100;
    }
    covers =
        covers && contains(*found.moment, robot.boxesAt(values, Eigen::Isometry3d::Identity()));
  }
  return covers;
}

TEST(StoppingBoxes, CoverTheWorstStopAndNoLongerOne) {
  int covered = 0;
  constexpr int kStops = 30;
  for (std::uint64_t seed = 1; seed <= kStops; ++seed) {
    EXPECT_TRUE(coversWorstStop(1, seed)) << seed;
    covered += coversWorstStop(1.1, seed);
  }
  EXPECT_LT(covered, kStops / 2);
}

TEST(StoppingBoxes, ARobotAtRestHasItsBoxes) {
  Robotics robot(goodParameters());
  const Values values = robot.values({{"pan", 0.3}, {"roll", 2}, {"finger", 0.01}});
  robot.move(values, Values(values.size(), 0.0));
  const WayBoxes found = robot.stopping();
  EXPECT_EQ(found.problem, "");
  const auto boxes = robot.boxesAt(values, Eigen::Isometry3d::Identity());
  ASSERT_EQ(found.moment->bodies.size(), boxes.size());
  for (const Moment::Body& body : found.moment->bodies)
    EXPECT_TRUE(body.box.isApprox(boxes.at(found.moment->name(body)), 1e-8));
}

std::map<std::string, Aabb> boxesOf(const WayBoxes& found) {
  std::map<std::string, Aabb> result;
  for (const Moment::Body& body : found.moment->bodies)
    result.emplace(found.moment->name(body), body.box);
  return result;
}

WayBoxes stoppingOf(Robotics& robot) {
  robot.move(robot.values({}), robot.values({{"pan", 1.0}, {"roll", 1.5}}));
  return robot.stopping();
}

TEST(StoppingBoxes, HavePaddingAndStampsOfTheBoxes) {
  Robotics bare(goodParameters());
  const auto without = boxesOf(stoppingOf(bare));
  Parameters parameters = goodParameters();
  parameters.padding = 0.05;
  parameters.link_padding = {{"hand", 0.02}};
  Robotics robot(parameters);
  const WayBoxes found = stoppingOf(robot);
  ASSERT_EQ(found.moment->bodies.size(), without.size());
  for (const Moment::Body& body : found.moment->bodies) {
    const std::string name(found.moment->name(body));
    const double padding = name == "hand" ? 0.02 : 0.05;
    EXPECT_TRUE(body.box.isApprox(padded(without.at(name), padding), 1e-9)) << name;
    EXPECT_EQ(body.stamp, static_cast<std::int64_t>(kStamp * 1e9)) << name;
  }
}

/// As large as the hand, and at its place. A box of another node keeps the stamp that it has there.
TEST(StoppingBoxes, AnObjectThatFollowsALinkMovesWithIt) {
  constexpr auto kSent = static_cast<std::int64_t>((kStamp - 0.1) * 1e9);
  for (const bool is_neighbour : {false, true}) {
    Robotics robot(goodParameters());
    ObjectContent content;
    content.bounded.name = "held/1";
    content.bounded.shapes = {{nullptr, Solid::kBox, {0.1, 0.1, 0.1}, Eigen::Affine3d::Identity()}};
    content.frame = "hand";
    content.is_neighbour = is_neighbour;
    content.stamp = is_neighbour ? kSent : 0;
    robot.scene().objects.put({"held", 1}, content, ros::Time(kStamp));
    const WayBoxes found = stoppingOf(robot);
    const auto boxes = boxesOf(found);
    ASSERT_EQ(boxes.count("held/1"), 1u);
    EXPECT_EQ(found.moment->bodies.back().stamp,
              is_neighbour ? kSent : static_cast<std::int64_t>(kStamp * 1e9));
    EXPECT_TRUE(boxes.at("held/1").isApprox(boxes.at("hand"), 1e-9)) << is_neighbour;
    EXPECT_GT(boxes.at("hand").diagonal().norm(), 0.3);  // it moves
  }
}

/// 6,400 km from the origin of the fixed frame, too.
TEST(StoppingBoxes, SlowMotionFarAwayIsNoRounding) {
  for (const double far : {1.0, 6.4e6}) {
    Robotics robot(goodParameters());
    for (int i = 20; i >= 0; --i) {
      const Eigen::Vector3d place(far, far / 2, -0.1 * i / MovingRobot::kRate);
      robot.add("map", "cart", kStamp - i / MovingRobot::kRate,
                Eigen::Isometry3d(Eigen::Translation3d(place)));
    }
    ObjectContent content;
    content.bounded.name = "cart/1";
    content.bounded.shapes = {{nullptr, Solid::kBox, {0.1, 0.1, 0.1}, Eigen::Affine3d::Identity()}};
    content.frame = "cart";
    robot.scene().objects.put({"cart", 1}, content, ros::Time(kStamp));
    EXPECT_EQ(stoppingOf(robot).moment->incomplete, Names{"cart/1"}) << far;
  }
}

/// Its speed, its way or the box is too large for a number.
TEST(StoppingBoxes, AJumpTooLargeForNumbersIsTold) {
  for (const double far : {1e153, 1e200, 1.7e308}) {
    Parameters parameters = goodParameters();
    parameters.deceleration = {{"slide", 5}};
    MovingRobot robot(R"(<robot name="r"><link name="base"/>
        <link name="arm"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
        <joint name="slide" type="prismatic"><parent link="base"/><child link="arm"/>
          <axis xyz="1 0 0"/><limit lower="-1.7e308" upper="1.7e308" effort="1" velocity="1"/>
        </joint></robot>)",
                      parameters);
    for (int i = 10; i >= 0; --i)
      robot.send(kStamp - i / kRate, {i == 1 ? far : 0});
    const WayBoxes found = robot.stopping();
    EXPECT_EQ(found.moment->incomplete, Names{"arm"}) << far;
    EXPECT_TRUE(found.moment->bodies.empty()) << far;
    EXPECT_NE(found.problem.find("too large for numbers"), std::string::npos) << found.problem;
  }
}

/// How far down a slide that rises through 0.1175 m may go.
double lowestOfSlide(const std::string& limits) {
  Parameters parameters = goodParameters();
  parameters.deceleration = {{"slide", 5}};
  parameters.during_reaction = "limit";
  MovingRobot robot(R"(<robot name="r"><link name="base"/>
      <link name="arm"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
      <joint name="slide" type="prismatic"><parent link="base"/><child link="arm"/>
        <axis xyz="1 0 0"/><limit effort="1" velocity="1" )" +
                        limits + "/></joint></robot>",
                    parameters);
  for (int i = 50; i >= 0; --i)
    robot.add("map", "base", kStamp - 0.005 - 0.01 * i, Eigen::Isometry3d::Identity());
  for (int i = 5; i >= 0; --i) {
    const Eigen::Vector3d place(0.12 - 0.5 * 0.04 * i, 0, 0);
    robot.add("base", "arm", kStamp - 0.04 * i, Eigen::Isometry3d(Eigen::Translation3d(place)));
  }
  robot.scene().update(ros::Time(kStamp));
  const WayBoxes found = robot.stopping();
  EXPECT_EQ(found.problem, "");
  return boxesOf(found).at("arm").min().x();
}

/// It may reach its limit within the reaction time, whatever the transform before the stamp of the
/// base says.
TEST(StoppingBoxes, LimitsCountFromThePoseOfTheStamp) {
  const double lowest = lowestOfSlide("lower=\"0\" upper=\"2\"");
  EXPECT_LE(lowest, -0.1);
  EXPECT_GT(lowest, -0.11);
}

/// No value obeys them.
TEST(StoppingBoxes, LimitsThatAreSwappedDoNotCount) {
  EXPECT_LT(lowestOfSlide("lower=\"2\" upper=\"0\""), -0.15);
}

/// As where the description gives none, which is 0 and 0: the joint moves through them.
TEST(StoppingBoxes, LimitsThatAreEqualDoNotCount) {
  EXPECT_LT(lowestOfSlide("lower=\"0.1175\" upper=\"0.1175\""), -0.15);
}

TEST(StoppingBoxes, AContinuousJointMayWrap) {
  Robotics robot(goodParameters());
  const Values values = robot.values({{"roll", M_PI + 0.01}});
  robot.move(values, robot.values({{"roll", 1.0}}));
  EXPECT_EQ(robot.incomplete(), Names());
}

/// Half a turn from one transform to the next: in which direction is not known.
TEST(StoppingBoxes, HalfATurnIsTold) {
  Robotics robot(goodParameters());
  robot.move(robot.values({}), robot.values({{"roll", M_PI * kRate}}));
  EXPECT_EQ(robot.incomplete(), (Names{"fore", "hand", "left", "right"}));
  EXPECT_NE(robot.stopping().problem.find("joint \"roll\" turns by 90 degrees or more"),
            std::string::npos);
}

TEST(StoppingBoxes, WhatDoesNotFitAJointIsTold) {
  for (const double error : {0.0009, 0.0011}) {
    Robotics other(goodParameters());
    const Joint& pan = other.robot().joints[other.joint("pan")];
    Eigen::Isometry3d pose = pan.parent_from_joint;
    pose.translation() += error * (pan.parent_from_joint.linear() * Eigen::Vector3d::UnitX());
    for (int i = 20; i >= 0; --i) {
      other.add("map", "base", kStamp - i / kRate, Eigen::Isometry3d::Identity());
      other.add("base", "upper", kStamp - i / kRate, pose);
    }
    other.scene().update(ros::Time(kStamp));
    const WayBoxes found = other.stopping();
    EXPECT_EQ(found.moment->bodies.size(), error < 0.001 ? 2u : 1u);
    EXPECT_EQ(found.problem.find("upper: a transform does not fit joint \"pan\"") == 0,
              error > 0.001)
        << found.problem;
  }
}

TEST(StoppingBoxes, AJointWithoutDecelerationIsTold) {
  Parameters parameters = goodParameters();
  parameters.deceleration.erase("roll");
  Robotics robot(parameters);
  robot.move(robot.values({}), robot.values({}));
  EXPECT_EQ(robot.incomplete(), (Names{"fore", "hand", "left", "right"}));
  EXPECT_EQ(robot.stopping().problem,
            "fore: joint \"roll\" has no ~deceleration; set it; incomplete are 3 more");
}

TEST(StoppingBoxes, TransformsTooFarApartAreTold) {
  Parameters parameters = goodParameters();
  parameters.velocity_window = 0.005;
  Robotics robot(parameters);
  robot.move(robot.values({}), robot.values({}));
  EXPECT_EQ(robot.incomplete().size(), robot.robot().links.size());
  EXPECT_NE(robot.stopping().problem.find("raise ~velocity_window"), std::string::npos);
}

Eigen::Isometry3d drivenBase(double way, double turn) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(3 + way, -2, 0);
  pose.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

TEST(StoppingBoxes, ABaseThatDrivesNeedsItsDeceleration) {
  for (const bool is_given : {false, true}) {
    Parameters parameters = goodParameters();
    if (!is_given) parameters.base_deceleration.clear();
    Robotics robot(parameters);
    const Values values = robot.values({});
    for (int i = 20; i >= 0; --i)
      robot.send(kStamp - i / kRate, values, drivenBase(-0.5 * i / kRate, -0.4 * i / kRate));
    const WayBoxes found = robot.stopping();
    EXPECT_EQ(found.moment->incomplete.size(), is_given ? 0 : robot.robot().links.size());
    EXPECT_EQ(found.problem.empty(), is_given) << found.problem;
    Eigen::Isometry3d pose = drivenBase(0, 0);
    for (int i = 0; is_given && i <= 60; ++i) {  // a twist that is constant, then fades
      EXPECT_TRUE(contains(*found.moment, robot.boxesAt(values, pose))) << i;
      const double part = std::min(1.0, 1 - (i * 0.01 - 0.1) / 0.5);
      const double turn = 0.4 * 0.01 * std::max(0.0, std::min(part, 1 - (i * 0.01 - 0.1) / 0.4));
      pose.translation() += pose.linear() * Eigen::Vector3d(0.5 * 0.01 * std::max(part, 0.0), 0, 0);
      pose.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
    }
  }
}

/// On a circle of radius 1 m at 60 rad/s: the chord of 10 ms is shorter than the arc, and points
/// away from where the base goes next.
TEST(StoppingBoxes, ABaseOnACircleGoesItsArc) {
  Parameters parameters = goodParameters();
  parameters.base_deceleration = {{"linear", 1e6}, {"angular", 1e6}};
  parameters.reaction_time = 0.002;
  parameters.velocity_window = 0.01;
  Robotics robot(parameters);
  const Values values = robot.values({});
  const auto on_circle = [](double turn) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
    pose.translation() = Eigen::Vector3d(std::sin(turn), -std::cos(turn), 0);
    return pose;
  };
  for (int i = 20; i >= 0; --i)
    robot.send(kStamp - i / kRate, values, on_circle(-60 * i / kRate));
  const WayBoxes found = robot.stopping();
  EXPECT_EQ(found.problem, "");
  ASSERT_EQ(found.moment->bodies.size(), robot.robot().links.size());
  for (int i = 0; i <= 10; ++i)
    EXPECT_TRUE(contains(*found.moment, robot.boxesAt(values, on_circle(60 * 0.0002 * i)))) << i;
}

/// odom is between the map and the base.
void sendCorrected(Robotics& robot, double stamp, const Eigen::Isometry3d& map_from_odom,
                   const Eigen::Isometry3d& odom_from_base, bool is_base_above) {
  if (is_base_above) {
    robot.add("base", "odom", stamp, odom_from_base.inverse());
    robot.add("odom", "map", stamp, map_from_odom.inverse());
  } else {
    robot.add("map", "odom", stamp, map_from_odom);
    robot.add("odom", "base", stamp, odom_from_base);
  }
  for (const Joint& joint : robot.robot().joints)
    robot.add(robot.robot().links[joint.parent].name, robot.robot().links[joint.child].name, stamp,
              joint.parent_from_joint * jointMotion(joint, 0));
}

/// A localisation corrects odom in the map while the base drives in odom: along its way, against
/// it, or across. The map may be below the base, too.
TEST(StoppingBoxes, ACorrectionOfTheLocalisationHidesNoSpeed) {
  const Eigen::Vector3d driven(1, 0, 0);
  const Eigen::Isometry3d turned(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d correction = std::vector<Eigen::Vector3d>{
        {0, 0, 0}, {-1, 0, 0}, {0.5, 0, 0}, {-0.5, 0.7, 0}}[static_cast<std::size_t>(i / 2)];
    Robotics robot(goodParameters());
    for (int k = 20; k >= 0; --k) {
      const double before = k / kRate;
      Eigen::Isometry3d map_from_odom = turned;
      map_from_odom.translation() = turned.linear() * -before * correction;
      const Eigen::Isometry3d odom_from_base(Eigen::Translation3d(-before * driven));
      sendCorrected(robot, kStamp - before, map_from_odom, odom_from_base, i % 2 == 1);
    }
    robot.scene().update(ros::Time(kStamp));
    const WayBoxes found = robot.stopping();
    EXPECT_TRUE(found.moment->incomplete.empty());
    // It drives on by 0.6 m in odom, or by what the fixed frame shows.
    double farthest = 0;
    for (const Eigen::Vector3d& speed : {driven, Eigen::Vector3d(correction + driven)}) {
      Eigen::Isometry3d stopped = turned;
      const double way = speed.norm() * 0.1 + speed.squaredNorm() / 2;
      stopped.translation() = turned.linear() * speed.stableNormalized() * way;
      farthest = std::max(farthest, stopped.translation().norm());
      EXPECT_TRUE(contains(*found.moment, robot.boxesAt(robot.values({}), stopped))) << i;
    }
    const Eigen::Vector3d resting = robot.boxesAt(robot.values({}), turned).at("base").sizes();
    const Eigen::Vector3d size = boxesOf(found).at("base").sizes();
    EXPECT_LE((size - resting).maxCoeff(), 2 * farthest + 1e-3) << i;
    if (correction.isZero()) {
      EXPECT_LE(size.x() - resting.x(), farthest + 1e-3) << "it keeps its direction";
    }
  }
}

/// odom turns against the base: in the map the base only drives, in odom it only turns. It may do
/// both until it stands.
TEST(StoppingBoxes, ATurnThatOnlyOdomShowsBendsThePathInTheMap) {
  Parameters parameters = goodParameters();
  parameters.velocity_window = 0.05;
  Robotics robot(parameters);
  const auto turned = [](double angle) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  };
  const Eigen::Translation3d out(2, 0, 0);
  for (int i = 20; i >= 0; --i) {
    const double time = -i / kRate;
    sendCorrected(robot, kStamp + time, turned(-time), out * turned(time), false);
  }
  robot.scene().update(ros::Time(kStamp));
  const WayBoxes found = robot.stopping();
  EXPECT_TRUE(found.moment->incomplete.empty());
  for (const double side : {-1.0, 1.0}) {
    Eigen::Isometry3d pose(out);
    for (int i = 0; i < 210; ++i) {  // 2 m/s and 1 rad/s for 0.1 s, then both fade by 1 per s^2
      EXPECT_TRUE(contains(*found.moment, robot.boxesAt(robot.values({}), pose))) << side << i;
      const double braked = std::max(0.0, i * 0.01 + 0.005 - 0.1);
      pose.translation() -= pose.linear().col(1) * 0.01 * std::max(0.0, 2 - braked);
      pose.rotate(turned(side * 0.01 * std::max(0.0, 1 - braked)).rotation());
    }
  }
}

/// It drives by a frame below, in which it nods, with noise. The box is longer, and hardly wider.
TEST(StoppingBoxes, ABaseThatNodsKeepsItsDirection) {
  for (const double noise : {0.0, 1e-8, 1e-4}) {
    Robotics robot(goodParameters());
    for (int i = 20; i >= 0; --i) {
      const double before = i / kRate;
      robot.add("map", "footprint", kStamp - before,
                Eigen::Isometry3d(Eigen::Translation3d(-2 * before, 0, 0)));
      Eigen::Isometry3d nods(Eigen::AngleAxisd(i % 2 * 1e-4, Eigen::Vector3d::UnitY()));
      nods.translation() = Eigen::Vector3d(0, i % 2 * noise, i % 3 * noise);
      robot.add("footprint", "base", kStamp - before, nods);
    }
    robot.scene().update(ros::Time(kStamp));
    const Aabb box = boxesOf(robot.stopping()).at("base");
    EXPECT_GE(box.max().x(), 0.2 + 2) << "2 m/s, 1 m/s^2";
    EXPECT_LE(box.max().x(), 0.2 + 2 + 0.3);
    EXPECT_LE(box.max().y(), 0.15 + 0.3) << noise;
    EXPECT_GE(box.min().x(), -0.2 - 0.3);
  }
}

/// A whole turn within each piece of the window looks like standing.
TEST(StoppingBoxes, ABaseThatTurnsFullyWithinAPieceIsTold) {
  Parameters parameters = goodParameters();
  parameters.velocity_window = 0.2;
  Robotics robot(parameters);
  const Values values = robot.values({});
  for (int i = 80; i >= 0; --i)
    robot.send(kStamp - 0.0025 * i, values, drivenBase(0, -2 * M_PI / 16 * i));
  const WayBoxes found = robot.stopping();
  EXPECT_EQ(found.moment->incomplete.size(), robot.robot().links.size());
  EXPECT_NE(found.problem.find("90 degrees or more"), std::string::npos) << found.problem;
}

}  // namespace
}  // namespace link_bounds

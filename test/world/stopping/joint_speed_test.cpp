// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The values and speeds of joints, from tf and from /joint_states.
#include "world/stopping/joint_speed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "link_bounds/robot/urdf/kinematics.h"
#include "testing/brute_force.h"
#include "testing/moving_robot.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr std::int64_t kPeriod = 10'000'000;  // ns
constexpr std::int64_t kWindow = 50'000'000;  // ns
constexpr std::int64_t kEnd = 1'000'000'000;  // ns, the newest stamp

double secondsUntilEnd(std::int64_t stamp) {
  return static_cast<double>(kEnd - stamp) / 1e9;
}

Joint randomJoint(Motion motion, Random& random) {
  Joint joint;
  joint.name = "joint";
  joint.motion = motion;
  joint.parent_from_joint = Eigen::Isometry3d(random.rigid(1).matrix());
  joint.axis = random.vector(1).normalized();
  return joint;
}

/// At a constant speed until kEnd, where it has `value`.
EdgeSamples samplesOf(const Joint& joint, double value, double speed) {
  EdgeSamples samples;
  for (std::int64_t stamp = kEnd - kWindow; stamp <= kEnd; stamp += kPeriod) {
    const double then = value - speed * secondsUntilEnd(stamp);
    samples.poses.push_back({stamp, joint.parent_from_joint * jointMotion(joint, then)});
  }
  return samples;
}

JointState stateAtEnd(const Joint& joint, double value, double speed) {
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, value);
  return jointState(joint, pose, samplesOf(joint, value, speed), kWindow);
}

/// Axes of all directions, so of all signs; turning joints also past half a turn.
TEST(JointState, HasValueAndSpeedOfEachType) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const bool turns = i % 2 == 0;
    const Joint joint = randomJoint(turns ? Motion::kRotation : Motion::kTranslation, random);
    const double value = random.uniform(-7, 7);
    const double speed = random.uniform(-100, 100);
    const JointState state = stateAtEnd(joint, value, speed);
    ASSERT_EQ(state.problem, "");
    const double error = state.value - value;
    EXPECT_NEAR(turns ? withoutTurns(error) : error, 0, 1e-9);
    EXPECT_LE(state.speed.lower, speed);
    EXPECT_GE(state.speed.upper, speed);
    EXPECT_NEAR(state.speed.upper - state.speed.lower, 0, 1e-4);
  }
}

/// In which direction it turned by half a turn is not known, so it is not guessed.
TEST(JointState, HalfATurnBetweenTransformsIsAProblem) {
  Random random(3);
  for (const double turn : {0.49, 0.51, 0.99, 1.01, 1.49}) {
    const Joint joint = randomJoint(Motion::kRotation, random);
    const double speed = turn * M_PI / (static_cast<double>(kPeriod) / 1e9);
    const JointState state = stateAtEnd(joint, 0, speed);
    EXPECT_EQ(state.problem.empty(), turn < 0.5) << turn;
  }
}

using Reports = std::vector<JointReport>;

Reports reportsOf(double value, double speed, bool have_velocities) {
  Reports reports;
  for (std::int64_t stamp = kEnd - kWindow; stamp <= kEnd; stamp += kPeriod) {
    JointReport report{stamp, value - speed * secondsUntilEnd(stamp), {}};
    if (have_velocities) report.velocity = speed;
    reports.push_back(report);
  }
  return reports;
}

TEST(JointState, OfReportsKnowsTurns) {
  Random random(4);
  const Joint joint = randomJoint(Motion::kRotation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 9.0);
  for (const bool have_velocities : {false, true}) {
    const JointState state =
        jointState(joint, pose, reportsOf(9.0, 1.5, have_velocities), kEnd, kWindow);
    EXPECT_EQ(state.problem, "");
    EXPECT_NEAR(state.value, 9.0, 1e-12);
    EXPECT_TRUE(state.are_turns_known);
    EXPECT_NEAR(state.speed.lower, 1.5, 1e-5);
    EXPECT_NEAR(state.speed.upper, 1.5, 1e-5);
  }
}

/// As a driver sends them that does not measure velocities.
TEST(JointState, VelocitiesThatThePositionsRefuteAreNotBelieved) {
  Random random(7);
  const Joint joint = randomJoint(Motion::kRotation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 9.0);
  for (const double speed : {1.5, -0.2}) {
    Reports reports = reportsOf(9.0, speed, true);
    for (const double velocity : {0.0, speed / 2, -speed}) {
      for (JointReport& report : reports)
        report.velocity = velocity;
      const JointState state = jointState(joint, pose, reports, kEnd, kWindow);
      EXPECT_EQ(state.problem, "");
      EXPECT_LE(state.speed.lower, std::min(speed, velocity) + 1e-9);
      EXPECT_GE(state.speed.upper, std::max(speed, velocity) - 1e-9);
      EXPECT_GE(state.piece, static_cast<double>(kPeriod) / 1e9) << "speeds are means";
    }
  }
}

/// A joint that swings, whose driver filters velocities, or sends a zero now and then.
TEST(JointState, VelocitiesThatAreLateOrMissingAreNotBelieved) {
  Random random(11);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  constexpr double kReach = 0.6, kTurn = 6.5, kLate[] = {0, 0.002, 0.005, 0.02, 0.04};
  constexpr std::int64_t kLongWindow = 4 * kWindow;
  const auto seconds = [](std::int64_t stamp) { return static_cast<double>(stamp) / 1e9; };
  const auto position = [&](std::int64_t stamp) {
    return kReach * std::sin(kTurn * seconds(stamp));
  };
  const auto speed = [&](double time) { return kReach * kTurn * std::cos(kTurn * time); };
  const double acceleration = kReach * kTurn * kTurn;
  double widest = 0;
  for (int driver = 0; driver < 6; ++driver) {
    for (std::int64_t end = kEnd; end < 3 * kEnd; end += kPeriod) {
      Reports reports;
      for (std::int64_t stamp = end - kLongWindow; stamp <= end; stamp += kPeriod) {
        const bool is_zero = driver == 5 && stamp / kPeriod % 2 == 0;
        const double late = driver < 5 ? kLate[driver] : 0;
        reports.push_back({stamp, position(stamp), is_zero ? 0 : speed(seconds(stamp) - late)});
      }
      const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, position(end));
      const JointState state = jointState(joint, pose, reports, end, kLongWindow);
      ASSERT_EQ(state.problem, "");
      const SpeedRange range = speedAtStamp(state, acceleration);
      EXPECT_LE(range.lower, speed(seconds(end)) + 1e-9) << "driver " << driver;
      EXPECT_GE(range.upper, speed(seconds(end)) - 1e-9) << "driver " << driver;
      if (driver == 0) widest = std::max(widest, range.upper - range.lower);
      if (HasFailure()) return;
    }
  }
  EXPECT_LT(widest, 1.1 * acceleration * 0.2) << "true velocities are believed";
}

/// From one report to the next it turns by 200 degrees.
TEST(JointState, ZeroVelocitiesTellNoDirectionOfAFastJoint) {
  Random random(9);
  const Joint joint = randomJoint(Motion::kRotation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 9.0);
  for (const double speed : {350.0, -350.0}) {
    Reports reports = reportsOf(9.0, speed, true);
    EXPECT_EQ(jointState(joint, pose, reports, kEnd, kWindow).problem, "");
    for (JointReport& report : reports)
      report.velocity = 0;
    const std::string problem = jointState(joint, pose, reports, kEnd, kWindow).problem;
    EXPECT_NE(problem.find("between two reports in joint_states, so its direction is not known"),
              std::string::npos)
        << problem;
  }
}

/// Positions of a joint without limits may jump by a turn. Where nothing moves, speeds are known at
/// the stamp.
TEST(JointState, TurnsAndRestAreNoDisagreement) {
  Random random(8);
  const Joint joint = randomJoint(Motion::kRotation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 3.2);
  Reports turning = reportsOf(3.2, 1.5, true);
  for (JointReport& report : turning)
    report.position = std::remainder(report.position, 2 * M_PI);
  ASSERT_GT(turning.front().position * -turning.back().position, 0) << "it passes half a turn";
  const JointState state = jointState(joint, pose, turning, kEnd, kWindow);
  EXPECT_NEAR(state.speed.lower, 1.5, 1e-5);
  EXPECT_NEAR(state.speed.upper, 1.5, 1e-5);
  for (const double noise : {0.0, 1e-5}) {
    Reports resting = reportsOf(3.2, 0, true);
    resting.front().position += noise;
    EXPECT_EQ(jointState(joint, pose, resting, kEnd, kWindow).piece, 0);
  }
}

/// Without velocities, positions tell the direction of a continuous joint to less than 90 degrees.
TEST(JointState, PositionsOfAContinuousJointMayBeginTheTurnAnew) {
  Random random(12);
  Joint joint = randomJoint(Motion::kRotation, random);
  joint.limits.reset();
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 3.2);
  Reports turning = reportsOf(3.2, 1.5, false);
  const JointState expected = jointState(joint, pose, turning, kEnd, kWindow);
  for (JointReport& report : turning)
    report.position = std::remainder(report.position, 2 * M_PI);
  ASSERT_GT(turning.front().position * -turning.back().position, 0) << "it passes half a turn";
  const Reports sent = turning;
  EXPECT_EQ(unwrap(joint, turning), "");
  const JointState state = jointState(joint, pose, turning, kEnd, kWindow);
  EXPECT_EQ(state.problem, "");
  EXPECT_NEAR(state.speed.lower, expected.speed.lower, 1e-5);
  EXPECT_NEAR(state.speed.upper, expected.speed.upper, 1e-5);
  EXPECT_GT(state.speed.lower, 0);
  turning.back().position += 2;
  EXPECT_NE(unwrap(joint, turning).find("90 degrees or more"), std::string::npos);
  turning = sent;
  joint.limits = Limits{-9, 9};  // then they say how far it turned
  EXPECT_EQ(unwrap(joint, turning), "");
  EXPECT_LT(jointState(joint, pose, turning, kEnd, kWindow).speed.lower, -10);
}

/// A driver that does not measure it sends 0, and positions more rarely than the window.
TEST(JointState, ZeroVelocityOfOneReportIsNoRest) {
  Random random(13);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  for (const double velocity : {0.0, 1e-9}) {
    const Reports one{{kEnd, 0, velocity}};
    const JointReport before{kEnd - 2 * kWindow, 0.01, velocity};
    const JointState state = jointState(joint, joint.parent_from_joint, one, kEnd, kWindow, before);
    EXPECT_EQ(state.problem.empty(), velocity != 0) << state.problem;
  }
  for (const double moved : {0.0, 0.9e-4, 1.1e-4}) {
    const JointReport before{kEnd - 2 * kWindow, moved, 0.0};
    const JointState state =
        jointState(joint, joint.parent_from_joint, {{kEnd, 0, 0.0}}, kEnd, kWindow, before);
    EXPECT_EQ(state.problem.empty(), moved < 1e-4) << "where it was before, it may have rested";
    if (state.problem.empty()) {
      EXPECT_GT(state.unseen, 0);
    }
  }
}

/// Of a driver that filters velocities for 0.1 s and sends them every 0.1 s, while a joint speeds
/// up from rest.
TEST(JointState, OneVelocityOfAWindowIsBelievedAsFarAsThePositionsTell) {
  constexpr double kAcceleration = 10, kFilter = 0.1;
  constexpr std::int64_t kLongPeriod = 2 * kWindow;
  Random random(14);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  for (double time = 0.01; time < 0.5; time += 0.01) {
    const auto report = [&](double at, std::int64_t stamp) {
      const double since = std::max(at, 0.0);
      const double late = kFilter * (1 - std::exp(-since / kFilter));
      return JointReport{stamp, kAcceleration / 2 * since * since, kAcceleration * (since - late)};
    };
    const JointReport last = report(time, kEnd);
    const JointReport before = report(time - 2 * kWindow / 1e9, kEnd - kLongPeriod);
    const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, last.position);
    const JointState state = jointState(joint, pose, {last}, kEnd, kWindow, before);
    ASSERT_EQ(state.problem, "");
    EXPECT_GE(speedAtStamp(state, kAcceleration).upper, kAcceleration * time) << time;
  }
  const Reports steady = reportsOf(0.5, 1.5, true);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 0.5);
  const JointReport before{kEnd - kLongPeriod, 0.5 - 1.5 * 0.1, 1.5};
  const JointState state = jointState(joint, pose, {steady.back()}, kEnd, kWindow, before);
  EXPECT_NEAR(speedAtStamp(state, kAcceleration).upper, 1.5, 1e-3) << "measured and steady";
}

/// A trapezoid of velocities that jump is wrong by more than the joint can gain, which the
/// positions alone bound.
TEST(JointState, WhatPositionsBoundIsNotWidenedByWrongVelocities) {
  constexpr double kAcceleration = 10;
  Random random(15);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 0.5);
  Reports wrong = reportsOf(0.5, 1.5, true);
  for (JointReport& report : wrong)
    report.velocity = 0.1;
  const SpeedRange speed =
      speedAtStamp(jointState(joint, pose, wrong, kEnd, kWindow), kAcceleration);
  const SpeedRange expected = speedAtStamp(
      jointState(joint, pose, reportsOf(0.5, 1.5, false), kEnd, kWindow), kAcceleration);
  EXPECT_NEAR(speed.upper, expected.upper, 1e-6);
}

TEST(JointStates, TellTheLastReportBeforeAStamp) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  JointStates states;
  states.add("a", {48 * kSecond, 3, 1.0});
  EXPECT_FALSE(states.lastBefore("a", 50 * kSecond)) << "it is too long ago";
  EXPECT_FALSE(states.lastBefore("b", 50 * kSecond));
  states.add("a", {49 * kSecond, 4, 1.0});
  states.add("a", {50 * kSecond, 5, 1.0});
  const auto last = states.lastBefore("a", 50 * kSecond);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->position, 4);
  EXPECT_FALSE(states.lastBefore("a", 48 * kSecond));
}

/// It goes there and back within a window, so the positions at its ends are equal.
TEST(JointState, ZeroVelocitiesHideNoTurnBack) {
  Random random(11);
  const Joint joint = randomJoint(Motion::kRotation, random);
  Reports reports = reportsOf(0, 0, true);
  for (std::size_t i = 1; i + 1 < reports.size(); ++i)
    reports[i].position = 5e-3;
  const JointState state = jointState(joint, joint.parent_from_joint, reports, kEnd, kWindow);
  EXPECT_GE(state.piece, static_cast<double>(kWindow) / 5e9);
}

/// The last two positions differ by less than their noise, but it speeds up.
TEST(JointState, ZeroVelocitiesHideABeginFromRest) {
  constexpr double kAcceleration = 100;
  Random random(10);
  const Joint joint = randomJoint(Motion::kRotation, random);
  for (const double way : {0.0, 2e-5, 9.9e-5}) {
    Reports reports = reportsOf(0, 0, true);
    reports.back().position = way;
    const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, way);
    const JointState state = jointState(joint, pose, reports, kEnd, kWindow);
    const SpeedRange speed = speedAtStamp(state, kAcceleration);
    const double fastest = std::sqrt(2 * kAcceleration * way);
    EXPECT_GE(speed.upper, fastest);
    EXPECT_LE(speed.lower, -fastest);
    EXPECT_LE(speed.upper, 0.16) << "as after 0.1 mrad";
    for (JointReport& report : reports)
      report.velocity = 1e-3;
    // Measured velocities are believed, but for what the last positions leave open.
    const double open = std::abs(way - 1e-3 * static_cast<double>(kPeriod) / 1e9);
    EXPECT_NEAR(speedAtStamp(jointState(joint, pose, reports, kEnd, kWindow), kAcceleration).upper,
                std::max(1e-3, way / 0.01) + std::sqrt(4 * kAcceleration * open), 1e-3);
  }
}

TEST(JointState, OfReportsMustAgreeWithTf) {
  Random random(5);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  for (const double error : {0.0009, 0.0011}) {
    const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 0.5 + error);
    const JointState state = jointState(joint, pose, reportsOf(0.5, 0, true), kEnd, kWindow);
    EXPECT_EQ(state.problem.find("tf and joint_states differ") == 0, error > 1e-3) << state.problem;
  }
}

TEST(JointState, OfOldReportsIsAProblem) {
  Random random(6);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint;
  for (const Reports& reports : {Reports{}, Reports{{kEnd - 2 * kWindow, 0, 0.0}}}) {
    const JointState state = jointState(joint, pose, reports, kEnd, kWindow);
    EXPECT_EQ(state.problem.find("joint_states has joint \"joint\" too rarely"), 0u);
  }
}

/// It may have moved there and back in between. Velocities tell.
TEST(JointState, OfPositionsFartherApartThanTheWindowIsAProblem) {
  Random random(7);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint;
  const auto problem = [&](std::int64_t gap, std::optional<double> velocity) {
    const Reports reports{{kEnd - kPeriod, 0, velocity}, {kEnd - kPeriod + gap, 0, velocity}};
    return jointState(joint, pose, reports, kEnd, kWindow).problem;
  };
  EXPECT_EQ(problem(kWindow, std::nullopt), "");
  EXPECT_EQ(problem(kWindow + 1, std::nullopt).find("joint_states has joint"), 0u);
  EXPECT_EQ(problem(kWindow + 1, 0.5), "");
}

/// A joint that speeds up goes on to do so after the last report. Some velocities are always zero.
TEST(JointState, TheSpeedAtTheStampCountsTheTimeSinceTheLastPosition) {
  constexpr double kSpeed = 1;
  constexpr double kAcceleration = 0.5;
  Random random(7);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  const auto value = [](std::int64_t stamp) {
    const double time = -secondsUntilEnd(stamp);
    return kSpeed * time + kAcceleration / 2 * time * time;
  };
  for (const std::optional<double> velocity : {std::optional<double>(), std::optional<double>(0)}) {
    for (const std::int64_t age : {std::int64_t{0}, kWindow / 2, kWindow - kPeriod}) {
      Reports reports;
      for (const std::int64_t stamp : {kEnd - age - kPeriod, kEnd - age})
        reports.push_back({stamp, value(stamp), velocity});
      const JointState state = jointState(joint, joint.parent_from_joint, reports, kEnd, kWindow);
      ASSERT_EQ(state.problem, "");
      EXPECT_NEAR(speedAtStamp(state, kAcceleration).upper, kSpeed, 1e-4) << age;
    }
  }
}

/// One report after the stamp is among them.
/// It does not make the joint unknown. How fast the joint came there counts.
TEST(JointState, OfPositionsALateReportAfterAPauseIsNoPartOfThePieces) {
  Random random(7);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint;
  const Reports reports{{kEnd - 2 * kPeriod, 0, {}}, {kEnd - kPeriod, 0, {}}};
  Reports with_late = reports;
  with_late.push_back({kEnd - kPeriod + kWindow + 1, 1, {}});
  const JointState state = jointState(joint, pose, with_late, kEnd, kWindow);
  EXPECT_EQ(state.problem, "");
  const JointState expected = jointState(joint, pose, reports, kEnd, kWindow);
  EXPECT_EQ(state.piece, expected.piece);
  EXPECT_EQ(state.speed.lower, expected.speed.lower);
  const double mean = 1 / (static_cast<double>(kWindow + 1) / 1e9);
  EXPECT_GE(state.speed.upper, mean);
  EXPECT_LE(state.speed.upper, mean * 1.01 + 1e-3);
}

/// The joint moved and came back while no report came. Nobody's numbers are wrong.
TEST(JointState, WhatMovedDuringAPauseOfTheReportsWasReportedTooRarely) {
  Random random(7);
  const Joint joint = randomJoint(Motion::kTranslation, random);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, 0.5);
  Reports reports{{kEnd - 2 * kPeriod, 0, {}}, {kEnd - kPeriod, 0, {}}};
  const auto problem = [&] { return jointState(joint, pose, reports, kEnd, kWindow).problem; };
  EXPECT_EQ(problem().find("tf and joint_states differ"), 0u);
  reports.push_back({kEnd - kPeriod + kWindow + 1, 0, {}});
  EXPECT_EQ(problem().find("joint_states has joint \"joint\" too rarely"), 0u) << problem();
}

/// A publisher may invent names without end.
TEST(JointStates, OfMoreJointsThanAnyRobotHasAreIgnored) {
  JointStates states;
  for (std::size_t i = 0; i < JointStates::kMaxJoints + 10; ++i)
    states.add("joint " + std::to_string(i), {kEnd, 1, {}});
  states.add("joint 0", {kEnd + kPeriod, 1, {}});
  EXPECT_EQ(states.reports("joint 0", kEnd + kPeriod, kWindow)->size(), 2u);
  EXPECT_TRUE(states.reports("joint 9999", kEnd, kWindow));
  EXPECT_FALSE(states.reports("joint 10001", kEnd, kWindow));
}

TEST(JointStates, KeepsHistoryInAnyOrderUntilTimeJumpsBack) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  JointStates states;
  EXPECT_FALSE(states.reports("a", kEnd, kWindow));
  for (const std::int64_t stamp : {50 * kSecond, 50 * kSecond - kPeriod, 50 * kSecond + kPeriod})
    states.add("a", {stamp, 1, 2.0});
  states.add("a", {0, 1, 2.0});  // without a stamp, as the next one without a position
  states.add("a", {50 * kSecond + 1, std::numeric_limits<double>::quiet_NaN(), 2.0});
  const auto reports = states.reports("a", 50 * kSecond, kWindow);
  ASSERT_TRUE(reports);
  ASSERT_EQ(reports->size(), 2u);
  EXPECT_EQ(reports->front().stamp, 50 * kSecond - kPeriod);
  states.add("a", {3 * kSecond, 1, 1.1e100});
  EXPECT_EQ(states.reports("a", 50 * kSecond, kWindow)->size(), 2u) << "it may be a fault";
  for (int i = 1; i < 10; ++i)
    states.add("a", {3 * kSecond + i * kPeriod, 1, 2.0});
  EXPECT_TRUE(states.reports("a", 50 * kSecond, kWindow)->empty());
  ASSERT_EQ(states.reports("a", 3 * kSecond + kPeriod, kWindow)->size(), 2u);
  EXPECT_FALSE(states.reports("a", 3 * kSecond, kWindow)->front().velocity);
}

TEST(JointStates, OfOneJointStayWhereTheClockOfAnotherPublisherIsAhead) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  JointStates states;
  for (int i = 0; i < 4; ++i) {
    states.add("a", {50 * kSecond + i * kPeriod, 1, 0.0});
    states.add("foreign", {70 * kSecond + i * kPeriod, 1, 0.0});
  }
  EXPECT_EQ(states.reports("a", 50 * kSecond + 3 * kPeriod, 3 * kPeriod)->size(), 4u);
}

TEST(JointStates, OfAPublisherWhoseClockIsRightStayWhereThatOfAnotherOneIsBehind) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  JointStates states;
  for (int i = 0; i < 4; ++i) {
    states.add("a", {50 * kSecond + i * kPeriod, 1, 0.0});
    states.add("a", {30 * kSecond + i * kPeriod, 1, 0.0});
  }
  EXPECT_EQ(states.reports("a", 50 * kSecond + 3 * kPeriod, 3 * kPeriod)->size(), 4u);
}

TEST(JointStates, OfBeforeAJumpOfTheClockAreForgottenHoweverShortItIs) {
  JointStates states;
  states.observeEpoch(1);
  states.add("a", {kEnd, 1, {}});
  states.observeEpoch(1);
  EXPECT_TRUE(states.reports("a", kEnd, kWindow));
  states.observeEpoch(2);
  EXPECT_FALSE(states.reports("a", kEnd, kWindow));
}

/// A gripper whose right finger goes the other way, twice as far.
constexpr char kGripper[] = R"(<robot name="gripper">
  <link name="palm"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
  <link name="left"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
  <link name="right"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
  <joint name="finger" type="prismatic"><parent link="palm"/><child link="left"/>
    <axis xyz="0 1 0"/><limit lower="-5" upper="5" effort="1" velocity="2"/></joint>
  <joint name="other" type="prismatic"><parent link="palm"/><child link="right"/>
    <axis xyz="0 1 0"/><limit lower="-5" upper="5" effort="1" velocity="2"/>
    <mimic joint="finger" multiplier="-2" offset="0.3"/></joint>
</robot>)";

Parameters gripperParameters() {
  Parameters parameters;
  parameters.fixed_frame = "palm";
  parameters.deceleration = {{"finger", 2}};
  return parameters;
}

constexpr double kSpeed = 0.5;                                       // of the finger
constexpr double kWay = kSpeed * 0.1 + kSpeed * kSpeed / (2 * 2.0);  // until it stands
constexpr double kOtherWay = 2 * kWay;  // twice the speed, twice the deceleration

void expectFingers(const WayBoxes& found) {
  ASSERT_EQ(found.problem, "");
  ASSERT_EQ(found.moment->bodies.size(), 3u);
  EXPECT_NEAR(found.moment->bodies[1].box.max().y(), 1 + 0.05 + kWay, 1e-6);
  EXPECT_NEAR(found.moment->bodies[1].box.min().y(), 1 - 0.05, 1e-6);
  EXPECT_NEAR(found.moment->bodies[2].box.min().y(), -1.7 - 0.05 - kOtherWay, 1e-6);
  EXPECT_NEAR(found.moment->bodies[2].box.max().y(), -1.7 + 0.05, 1e-6);
}

TEST(JointSpeed, AMimicJointGoesByItsMultiplier) {
  MovingRobot robot(kGripper, gripperParameters());
  robot.move(robot.values({{"finger", 1.0}}), {kSpeed, -2 * kSpeed});
  expectFingers(robot.stopping());
}

/// The reports have the leader only, and come more often than tf.
TEST(JointSpeed, AMimicJointHasTheReportsOfItsLeader) {
  MovingRobot robot(kGripper, gripperParameters());
  robot.send(MovingRobot::kStamp - 1, robot.values({{"finger", 1.0 - kSpeed}}));
  robot.send(MovingRobot::kStamp, robot.values({{"finger", 1.0}}));
  EXPECT_NE(robot.stopping().problem, "");  // tf alone is too slow
  JointStates states;
  for (int i = 5; i >= 0; --i) {
    const double stamp = MovingRobot::kStamp - i * 0.01;
    states.add("finger", {static_cast<std::int64_t>(ros::Time(stamp).toNSec()),
                          1.0 - kSpeed * i * 0.01, kSpeed});
  }
  expectFingers(robot.stopping(&states));
}

/// Zeros count because the report before the window shows that the leader rested.
TEST(JointSpeed, AMimicJointRestsWithItsLeader) {
  MovingRobot robot(kGripper, gripperParameters());
  robot.move(robot.values({{"finger", 1.0}}), {0, 0});
  JointStates states;
  for (const double age : {0.2, 0.0}) {
    const ros::Time stamp(MovingRobot::kStamp - age);
    states.add("finger", {static_cast<std::int64_t>(stamp.toNSec()), 1.0, 0.0});
  }
  const WayBoxes found = robot.stopping(&states);
  ASSERT_EQ(found.problem, "");
  EXPECT_NEAR(found.moment->bodies[2].box.min().y(), -1.7 - 0.05, 1e-6);
  EXPECT_NEAR(found.moment->bodies[2].box.max().y(), -1.7 + 0.05, 1e-6);
}

/// While a clock is paused, the same stamps come again; a bag that is played again begins anew.
TEST(JointSpeed, PausedAndRestartedClocks) {
  MovingRobot robot(kGripper, gripperParameters());
  const auto end = robot.values({{"finger", 1.0}});
  robot.move(end, {kSpeed, -2 * kSpeed});
  for (int i = 0; i < 3; ++i)
    robot.send(MovingRobot::kStamp, end);
  expectFingers(robot.stopping());
  robot.tf().clear();
  robot.scene().frames.updateAll(ros::Time(1.0));
  robot.send(1.0, end);
  EXPECT_NE(robot.stopping().problem.find("do not reach back for ~velocity_window yet"),
            std::string::npos);
  EXPECT_EQ(robot.stopping().moment->incomplete, (std::vector<std::string>{"left", "right"}));
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of links whose joints move at random; the offsets of stops, and the values of joints.
#include "robot/stopping/moving_link.h"

#include <gtest/gtest.h>

#include <iostream>
#include <limits>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/stopping/joint_fit.h"
#include "robot/stopping/stop_offsets.h"
#include "testing/sampled_links.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

/// Links of all shapes, behind joints of any width up to more than a turn.
TEST(MovingLink, RandomMotionsStayInside) {
  Random random(5);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions(300); ++i) {
    const BoundedLink link = randomLink(random);
    const Eigen::Affine3d pose(random.rigid(random.magnitude(-1, 5)).matrix());
    std::vector<MovingJoint> joints;
    const double widest = random.magnitude(-4, 1);
    for (int k = static_cast<int>(random.uniform(0, 9)); k > 0; --k) {
      MovingJoint joint{static_cast<MovingJoint::Kind>(static_cast<int>(random.uniform(0, 3))),
                        pose.translation() + random.vector(1), random.vector(1).normalized()};
      joint.offsets = {-random.uniform(0, widest), random.uniform(0, widest)};
      joint.distance = random.uniform(0, widest);
      joint.spread = random.uniform(0, 1);
      joint.turn = random.uniform(0, widest);
      joints.push_back(joint);
    }
    const auto bounds = boxOfMoving(link, pose, joints);
    ASSERT_TRUE(bounds);
    for (int k = 0; k < 30; ++k) {
      Eigen::Affine3d moved = Eigen::Affine3d::Identity();
      for (const MovingJoint& joint : joints) {
        const double part = std::min(std::max(random.uniform(-0.5, 1.5), 0.0), 1.0);
        const double offset =
            joint.offsets.lower + part * (joint.offsets.upper - joint.offsets.lower);
        const Eigen::Translation3d at(joint.origin);
        if (joint.kind == MovingJoint::Kind::kTurn) {
          moved = moved * at * Eigen::AngleAxisd(offset, joint.axis) * at.inverse();
        } else if (joint.kind == MovingJoint::Kind::kSlide) {
          moved = moved * Eigen::Translation3d(offset * joint.axis);
        } else {
          const Eigen::Vector3d across = joint.axis.cross(random.vector(1)).normalized();
          const Eigen::AngleAxisd deviation(part * joint.spread, across);
          const Eigen::Vector3d path = joint.distance * part * (deviation * joint.axis);
          const Eigen::AngleAxisd turn(part * joint.turn, random.vector(1).normalized());
          moved = moved * Eigen::Translation3d(path) * at * turn * at.inverse();
        }
      }
      const Aabb box = *linkBox(link, moved * pose);
      for (int face = 0; face < 6; ++face)
        nearest = std::min(nearest, faceGap(*bounds, box, face));
    }
  }
  EXPECT_GE(nearest, 0);
}

/// Poses of a link at random offsets, at the ends of all joints, and where single offsets bring the
/// face farther out, again and again.
Aabb attainedBox(const BoundedLink& link, const Eigen::Affine3d& pose,
                 const std::vector<MovingJoint>& joints) {
  const auto boxAt = [&](const std::vector<double>& parts) {
    Eigen::Affine3d moved = Eigen::Affine3d::Identity();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const auto [lower, upper] = joints[i].offsets;
      const Eigen::Translation3d at(joints[i].origin);
      moved = moved * at * Eigen::AngleAxisd(lower + parts[i] * (upper - lower), joints[i].axis) *
              at.inverse();
    }
    return *linkBox(link, moved * pose);
  };
  constexpr int kPasses = 4;
  constexpr int kParts = 16;
  Aabb attained = boxAt(std::vector<double>(joints.size(), 0.5));
  for (int face = 0; face < 6; ++face) {
    std::vector<double> parts(joints.size(), 0.5);
    for (std::size_t step = 0; step < kPasses * joints.size(); ++step) {
      double& part = parts[step % joints.size()];
      double best = part, smallest = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= kParts; ++k) {
        part = static_cast<double>(k) / kParts;
        const double gap = faceGap(attained, boxAt(parts), face);
        if (gap >= smallest) continue;
        smallest = gap;
        best = part;
      }
      part = best;
      attained.extend(boxAt(parts));
    }
  }
  return attained;
}

/// As a finger far from the joints of an arm: more joints than can be examined at several angles.
TEST(MovingLink, TurnsOfPointsAreNearlyExact) {
  constexpr double kShare = 0.05;   // of how far the face moved
  constexpr double kLength = 2e-3;  // m
  Random random(17);
  double worst = 0;
  for (int i = 0; i < repetitions(20); ++i) {
    Shape shape;
    shape.points = std::make_shared<const PointSet>(std::vector<Eigen::Vector3f>{{0, 0, 0}});
    const BoundedLink link = linkOf({shape});
    const Eigen::Affine3d pose(random.rigid(1).matrix());
    std::vector<MovingJoint> joints;
    for (int k = 0; k < 12; ++k) {
      MovingJoint joint{MovingJoint::Kind::kTurn,
                        pose.translation() + random.uniform(0.5, 1) * random.vector(1).normalized(),
                        random.vector(1).normalized()};
      joint.offsets = {-random.uniform(0, 0.02), random.uniform(0, 0.02)};
      joints.push_back(joint);
    }
    const auto bounds = boxOfMoving(link, pose, joints);
    ASSERT_TRUE(bounds);
    const Aabb start = *linkBox(link, pose);
    const Aabb attained = attainedBox(link, pose, joints);
    for (int face = 0; face < 6; ++face) {
      const double gap = faceGap(*bounds, attained, face);
      EXPECT_GE(gap, 0);
      worst = std::max(worst, gap - kShare * faceGap(attained, start, face));
    }
  }
  EXPECT_LE(worst, kLength);
  std::cout << "at most " << kShare << " of the way and " << worst << " m too far out\n";
}

TEST(StopOffsets, AreTheFormulasOfTheHeader) {
  const auto near = [](const Limits& offsets, double lower, double upper) {
    EXPECT_NEAR(offsets.lower, lower, 1e-12);
    EXPECT_NEAR(offsets.upper, upper, 1e-12);
  };
  const Braking plain{2, {}, 3};
  near(stopOffsets({0, 0}, plain, {0.5, false}), 0, 0);
  near(stopOffsets({1, 2}, plain, {0.5, false}), 0, 2 * 0.5 + 4.0 / 4);
  near(stopOffsets({-2, 1}, plain, {0.5, false}), -2, 0.5 + 1.0 / 4);
  near(stopOffsets({0, 0}, plain, {0.5, true}), -1.5 - 9.0 / 4, 1.5 + 9.0 / 4);
  const Braking slow{2, 4, 3};
  near(stopOffsets({1, 1}, slow, {0.25, true}), -0.125 - 1.0 / 4, 0.25 + 0.125 + 4.0 / 4);
  EXPECT_NEAR(stopOffsets({1, 1}, slow, {1, true}).upper, 2 * 0.5 + 3 * 0.5 + 9.0 / 4, 1e-12);
  near(stopOffsets({5, 5}, slow, {0.1, true}), -0.02 - 0.16 / 4, 0.5 + 25.0 / 4);
}

/// A driver may send any number as a velocity.
TEST(StopOffsets, OfTheLargestSpeedsAreNoSmaller) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const Braking slow{2, 4, 3};
  const Braking fast{2, 4, kLargest};
  for (const Braking& braking : {slow, fast}) {
    for (const double speed : {8e307, 9.5e307, kLargest}) {
      for (const double time : {0.0, 0.1, 1.0, 100.0}) {
        for (const bool may_speed_up : {false, true}) {
          const Limits stop = stopOffsets({-speed, speed}, braking, {time, may_speed_up});
          EXPECT_GE(stop.upper, 1e307);
          EXPECT_LE(stop.lower, -1e307);
        }
        const Limits travel = travelOffsets({-speed, speed}, braking, time);
        EXPECT_GE(travel.upper, speed * time);
        EXPECT_LE(travel.lower, -speed * time);
      }
    }
  }
}

TEST(JointFit, FindsTheValueOfEachType) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    Joint joint;
    joint.motion = i % 2 == 0 ? Motion::kRotation : Motion::kTranslation;
    joint.parent_from_joint = Eigen::Isometry3d(random.rigid(1).matrix());
    joint.axis = random.vector(1).normalized();
    const double value = random.uniform(-10, 10);
    const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, value);
    const JointFit fit = fitOf(joint, pose);
    const bool turns = joint.motion == Motion::kRotation;
    EXPECT_NEAR(turns ? withoutTurns(fit.value - value) : fit.value - value, 0, 1e-12);
    EXPECT_LT(fit.length_error + fit.angle_error, 1e-12);
    Eigen::Isometry3d off = pose;
    off.translation() += 0.002 * joint.parent_from_joint.linear() * joint.axis.unitOrthogonal();
    EXPECT_NEAR(fitOf(joint, off).length_error, 0.002, 1e-9);
    off = pose * Eigen::AngleAxisd(0.002, joint.axis.unitOrthogonal());
    EXPECT_NEAR(fitOf(joint, off).angle_error, 0.002, 1e-9);
  }
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot with the bodies of its links, and what a proof says of its own pose.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>

#include "link_bounds/geometry/distance/body_distance.h"
#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/pairs/pair_proofs.h"

namespace link_bounds {

constexpr double kTouch = 1e-7;  ///< m

using Model = LoadedRobot;

/// The distance that urdf_bounds --distances prints for the pose of the proof.
inline BodyDistance distanceInPose(const Model& model, const PairProof& proof) {
  const auto poses = linkPoses(model.robot, jointValues(model.robot, proof.pose));
  const BoundedRobot& bounded = model.bounded;
  const auto at = [&](std::size_t i) { return Eigen::Affine3d(poses[bounded.indices[i]]); };
  return *bodyDistance(bounded.bodies[proof.first], at(proof.first), bounded.bodies[proof.second],
                       at(proof.second));
}

/// What a proof says of its own pose.
inline void checkPose(const Model& model, const PairProof& proof, const PairGoal& goal) {
  if (proof.poses == 0) return;
  const BodyDistance distance = distanceInPose(model, proof);
  const bool collides = proof.verdict == Verdict::kSometimes || proof.verdict == Verdict::kAlways ||
                        proof.verdict == Verdict::kContactSampled;
  EXPECT_LE(proof.clearance, distance.upper);
  EXPECT_LE(distance.lower, proof.nearest);
  EXPECT_TRUE(!collides || distance.lower <= goal.clearance + kTouch) << distance.lower;
  EXPECT_TRUE(proof.verdict != Verdict::kNever || proof.clearance > goal.clearance);
  EXPECT_TRUE(proof.verdict != Verdict::kTouching || distance.lower <= goal.touching);
}

}  // namespace link_bounds

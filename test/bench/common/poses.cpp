// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Fixed seeds, and the random numbers of the tests.
#include "bench/common/poses.h"

#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr double kReach = 2;            ///< largest |coordinate| of a translation [m]
constexpr double kTurnPerPose = 2e-3;   ///< rad: 2 rad/s at 1 kHz
constexpr double kSlidePerPose = 1e-3;  ///< m along each axis

Poses makeTurningPoses() {
  Poses poses = randomPoses(kRandomPoses);
  brute_force::Random random(2);
  Eigen::Affine3d pose = random.rigid(kReach);
  const Eigen::AngleAxisd turn(kTurnPerPose, random.vector(1).normalized());
  while (poses.size() < kPoses) {
    poses.push_back(pose);
    pose.linear() = pose.linear() * turn.toRotationMatrix();
    pose.translation().array() += kSlidePerPose;
  }
  return poses;
}

Poses makeSlidingPoses() {
  Poses poses = turningPoses();
  const Eigen::Matrix3d rotation = poses[0].linear();
  for (Eigen::Affine3d& pose : poses)
    pose.linear() = rotation;
  return poses;
}

}  // namespace

Poses randomPoses(std::size_t count) {
  brute_force::Random random(1);
  Poses poses;
  while (poses.size() < count)
    poses.push_back(random.rigid(kReach));
  return poses;
}

const Poses& turningPoses() {
  static const Poses poses = makeTurningPoses();
  return poses;
}

const Poses& slidingPoses() {
  static const Poses poses = makeSlidingPoses();
  return poses;
}

}  // namespace link_bounds::bench

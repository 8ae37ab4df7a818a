// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Every face of a reach is rounded outward: against closed forms in quadruple precision, where the
// bound has no slack but rounding.
#include <gtest/gtest.h>

#include <iostream>
#include <limits>

#include "robot/reach/reach.h"
#include "robot/reach/support_table.h"
#include "testing/brute_force.h"
#include "testing/quad.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using QuadVector = Eigen::Matrix<Quad, 3, 1>;

Quad root(Quad square) {
  if (square <= 0) return 0;
  Quad result = std::sqrt(static_cast<double>(square));
  for (int i = 0; i < 2; ++i)
    result = (result + square / result) / 2;
  return result;
}

QuadVector quad(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

QuadVector placed(const Eigen::Isometry3d& pose, const QuadVector& point) {
  QuadVector result = quad(pose.translation());
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      result[row] += static_cast<Quad>(pose.linear()(row, column)) * point[column];
  }
  return result;
}

/// A full turn, a fixed joint, and one vertex: the support function of the vertex is linear, so
/// that its table is exact.
struct Arm {
  Robot robot;
  BoundedRobot bounded;
  Eigen::Vector3f vertex;
};

Joint randomJoint(std::size_t i, double size, brute_force::Random& random) {
  Joint joint;
  joint.name = "j" + std::to_string(i);
  joint.parent = i;
  joint.child = i + 1;
  joint.motion = i == 0 ? Motion::kRotation : Motion::kNone;
  joint.parent_from_joint = Eigen::Isometry3d(random.rigid(size).matrix());
  joint.axis = random.vector(1).normalized();
  return joint;
}

Arm randomRoundingArm(brute_force::Random& random) {
  Arm arm;
  const double size = random.magnitude(-3, 3);
  for (std::size_t i = 0; i < 2; ++i)
    arm.robot.joints.push_back(randomJoint(i, size, random));
  arm.robot.links.resize(3);
  arm.vertex = random.vector(size).cast<float>();
  Shape shape;
  shape.points = std::make_shared<const PointSet>(std::vector<Eigen::Vector3f>{arm.vertex});
  arm.bounded.links.push_back({"l", {shape}, 0, ""});
  arm.bounded.indices.push_back(2);
  return arm;
}

/// The largest coordinate along an axis that the vertex has, or the smallest.
Quad exactFace(const Arm& arm, std::size_t face) {
  const auto axis = static_cast<Eigen::Index>(face % 3);
  const Joint& turn = arm.robot.joints[0];
  const QuadVector point =
      placed(arm.robot.joints[1].parent_from_joint, quad(arm.vertex.cast<double>()));
  const QuadVector a = quad(turn.axis);
  // Rodrigues: constant + cos q * (point - constant) + sin q * across.
  const QuadVector constant = a * a.dot(point);
  const QuadVector across = constant + a.cross(point);
  const Quad middle = placed(turn.parent_from_joint, constant)[axis];
  const Quad cosine = placed(turn.parent_from_joint, point)[axis] - middle;
  const Quad sine = placed(turn.parent_from_joint, across)[axis] - middle;
  return middle + Quad(face < 3 ? -1 : 1) * root(cosine * cosine + sine * sine);
}

TEST(ReachRounding, FacesAreOutsideOfTheExactOnes) {
  brute_force::Random random(5);
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (int i = 0; i < repetitions(500); ++i) {
    const Arm arm = randomRoundingArm(random);
    const std::vector<JointRange> ranges = jointRanges(arm.robot);
    const Reach reach = *reachOf(arm.robot, arm.bounded, ranges, {1e9}).at(0);
    for (std::size_t face = 0; face < kFaces; ++face) {
      const Quad outside =
          Quad(face < 3 ? -1 : 1) * (Quad(reach.faces[face].at) - exactFace(arm, face));
      const double relative = static_cast<double>(outside) / reach.box().sizes().maxCoeff();
      smallest = std::min(smallest, relative);
      largest = std::max(largest, relative);
    }
  }
  EXPECT_GE(smallest, 0);
  EXPECT_LE(largest, 1e-10);
  std::cout << "outside of the exact faces by " << smallest << " to " << largest
            << " of the size of the box\n";
}

/// Of a set of points the table is exact in the directions of its grid, and never less elsewhere.
TEST(SupportTable, IsNeverLessThanTheSupport) {
  brute_force::Random random(6);
  const std::vector<Eigen::Vector3f> points = random.points(20, 1, {0.5, 0, 0});
  const auto support = [&](const Eigen::Vector3d& direction) {
    double best = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& point : points)
      best = std::max(best, point.cast<double>().dot(direction));
    return best;
  };
  for (const int cells : {2, 8, 32}) {
    std::vector<double> supports;
    for (const Eigen::Vector3d& direction : SupportTable::directions(cells))
      supports.push_back(support(direction));
    const SupportTable table(cells, supports);
    double most = 0;
    for (int i = 0; i < 10000; ++i) {
      const Eigen::Vector3d direction = random.vector(2);
      const double more = table.at(direction) - support(direction);
      ASSERT_GE(more, -1e-14) << direction.transpose();
      most = std::max(most, more / direction.norm());
    }
    EXPECT_LE(most, 4.0 / cells);
    for (const Eigen::Vector3d& direction : SupportTable::directions(cells))
      ASSERT_NEAR(table.at(3 * direction), 3 * support(direction), 1e-13);
    EXPECT_EQ(table.at(Eigen::Vector3d::Zero()), 0);
  }
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Robots for tests of their reach, and what holds for each of them.
#pragma once

#include <gtest/gtest.h>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/reach/reach.h"

namespace link_bounds {

inline BoundedRobot boundedBy(const Robot& robot) {
  return RobotLoader([](const MeshFile&) { return TriangleMesh(); }).load(robot, {}, {});
}

/// Each face is attained by its pose, which is in the ranges, as precisely as the gap says.
inline void expectAttained(const Robot& robot, const std::vector<JointRange>& ranges,
                           const BoundedLink& link, std::size_t index, const Reach& reach) {
  const double rounding = 1e-13 * (1 + reach.box().min().norm() + reach.box().max().norm());
  for (std::size_t face = 0; face < kFaces; ++face) {
    const ReachFace& found = reach.faces[face];
    const std::vector<double> values = jointValues(robot, found.pose);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_GE(values[i], ranges[i].lower) << robot.joints[i].name;
      EXPECT_LE(values[i], ranges[i].upper) << robot.joints[i].name;
    }
    const Aabb box = *linkBox(link, Eigen::Affine3d(linkPoses(robot, values)[index]));
    EXPECT_NEAR(faceOf(box, face), found.attained, rounding) << link.name << " face " << face;
    EXPECT_GE(beyond(face, found.at, found.attained), 0) << link.name << " face " << face;
    EXPECT_EQ(found.gap(), std::abs(found.at - found.attained));
  }
}

}  // namespace link_bounds

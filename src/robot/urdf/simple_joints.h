// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Floating and planar joints as chains of joints of one value each. So all that is known of
// prismatic and continuous joints holds for them, too.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The robot with each floating joint j replaced by j.x, j.y, j.z [m], then j.yaw, j.pitch, j.roll
/// [rad], which together are the pose that URDF writes as xyz and rpy, and each planar joint by
/// j.x, j.y [m], j.yaw [rad]. x, y and the axis of a planar joint are right-handed and orthogonal:
/// x is the next one of the joint's axes x, y, z after that which is nearest to the axis, projected
/// into the plane. So with the axis z they are x and y, with the axis x they are y and z. Links
/// keep their indices; further ones without geometry stand between the new joints. Throws
/// JointError if the URDF has a joint of a new name.
Robot withSimpleJoints(const Robot& robot);

/// Whether that joint of such a robot is part of a floating or planar joint of its root, or of a
/// link that fixed joints connect with the root.
bool movesBase(const Robot& robot, std::size_t joint);

/// Indices of the joints that move and mimic no other one.
std::vector<std::size_t> settableJoints(const Robot& robot);

/// Their names, each after a blank; " none" if there are none.
std::string settableNames(const Robot& robot);

/// Why such a robot has no movable joint of that name, and which names there are; "" if it has one.
std::string whyNoJoint(const Robot& robot, const std::string& name);

/// Which must exist.
const Joint& movableJoint(const Robot& robot, const std::string& name);

/// What is said of a value that is given for a joint that mimics another one.
std::string whyIgnored(const Joint& joint);

/// Which ranges are missing, and how to give them: of joints, given by their indices, that are
/// parts of floating or planar ones.
std::string missingRanges(const Robot& robot, std::vector<std::size_t> joints);

}  // namespace link_bounds

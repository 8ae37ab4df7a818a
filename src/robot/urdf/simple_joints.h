// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Floating and planar joints as chains of joints of one value each. So code for prismatic and
// continuous joints handles them, too.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The robot with each floating joint j replaced by j.x, j.y, j.z [m], then j.yaw, j.pitch, j.roll
/// [rad], which together are the pose that URDF writes as xyz and rpy, and each planar joint by
/// j.x, j.y [m], j.yaw [rad]. x, y and the axis of a planar joint are right-handed and orthogonal:
/// x is one of the axes of the joint's frame, projected into the plane: the next one after that
/// which is nearest to the planar joint's axis. So with the axis z they are x and y, with the axis
/// x they are y and z. Links keep their indices; further ones without geometry stand between the
/// new joints. Throws JointError if the URDF has a joint of a new name.
Robot withSimpleJoints(const Robot& robot);

/// Whether that joint of a robot with simple joints is part of a floating or planar joint of its
/// root, or of a link that fixed joints connect with the root.
bool movesBase(const Robot& robot, std::size_t joint);

/// Indices of the joints that move and mimic no other one.
std::vector<std::size_t> settableJoints(const Robot& robot);

/// The names of settableJoints(), each after a blank; " none" if there are none.
std::string settableNames(const Robot& robot);

/// Why a robot with simple joints has no movable joint of that name, and which names there are; ""
/// if it has one.
std::string whyNoJoint(const Robot& robot, const std::string& name);

/// The movable joint of that name, which must exist.
const Joint& movableJoint(const Robot& robot, const std::string& name);

/// The message about a value that is given for a joint that mimics another one.
std::string whyIgnored(const Joint& joint);

/// The message about missing ranges, and how to give them. `joints` are the indices of parts of
/// floating or planar joints.
std::string missingRanges(const Robot& robot, std::vector<std::size_t> joints);

}  // namespace link_bounds

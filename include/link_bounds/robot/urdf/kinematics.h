// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// From joint values to link poses, for boxes without tf.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// A joint value that the robot cannot take; what() names the joint and the reason.
class JointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One value [rad or m] per joint of the robot: the given ones, 0 for the others. Mimic joints
/// follow the joint they mimic; values given for them are ignored. Limits are not enforced. Throws
/// JointError for a name that is no movable joint, a value that is not finite, and mimic joints
/// that follow each other in a circle or follow no joint.
std::vector<double> jointValues(const Robot& robot, const std::map<std::string, double>& given);

/// The pose that a joint gives its child in the frame of the joint at `value` [rad or m]. Throws
/// JointError if the value is not 0 and the joint has no axis.
Eigen::Isometry3d jointMotion(const Joint& joint, double value);

/// The same for a joint about or along `axis`, of unit length. The identity for a motion that is
/// neither kRotation nor kTranslation.
Eigen::Isometry3d jointMotion(Motion motion, const Eigen::Vector3d& axis, double value);

/// The pose of each link in the frame of the root link [m]; `values` come from jointValues. Throws
/// JointError if a joint with a non-zero value has no axis.
std::vector<Eigen::Isometry3d> linkPoses(const Robot& robot, const std::vector<double>& values);

}  // namespace link_bounds

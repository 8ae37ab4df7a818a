// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The joints between two links as one chain, seen from the first link. No other joint changes how
// the two are to each other. And boxes of the values of these joints.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/pairs/body_cloud.h"
#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// The values of the variables [rad or m].
using PathValues = std::vector<double>;

/// A joint that can move. Joints on the way up to the common ancestor count backwards.
struct PathJoint {
  Eigen::Isometry3d before;  ///< from the frame of the joint before it, or the first link
  Motion motion;             ///< not kNone
  Eigen::Vector3d axis;      ///< unit, in the frame of the joint
  std::size_t variable;      ///< index in JointPath::variables
  double factor;             ///< the joint is at factor * variable + offset
  double offset;             ///< rad or m

  Eigen::Isometry3d motionAt(const PathValues& values) const;
};

/// A chain of joints at one pose, in the frame of the first link.
struct PlacedPath {
  std::vector<Axis> axes;  ///< one per joint
  Eigen::Isometry3d first_from_second;
};

/// Fixed joints, and those whose range is one value, are parts of the poses between the others.
struct JointPath {
  std::vector<std::size_t> variables;  ///< joints of the robot that move and mimic no other one
  std::vector<Limits> ranges;          ///< one per variable
  std::vector<std::size_t> unknown;    ///< joints of the robot on the way, without known ranges
  /// Values other than 0 of joints on which the way depends and that cannot move [rad or m].
  std::map<std::size_t, double> resting;
  std::vector<PathJoint> joints;                            ///< from the first link to the second
  Eigen::Isometry3d after = Eigen::Isometry3d::Identity();  ///< from the last joint to the second
  double length = 0;      ///< of all links of the chain and all prismatic ranges [m]
  std::size_t count = 0;  ///< of joints of any kind

  /// Several joints depend on the variable.
  bool isShared(std::size_t variable) const;

  /// The pose of the second link in the frame of the first.
  Eigen::Isometry3d pose(const PathValues& values) const;

  void place(const PathValues& values, PlacedPath& placed) const;
};

/// `ranges` has one per joint of the robot.
JointPath jointPath(const Robot& robot, const std::vector<JointRange>& ranges, std::size_t first,
                    std::size_t second);

/// Joint values: those of the variables of a path that differ from the centre by at most the half
/// widths.
struct JointBox {
  PathValues center;
  PathValues half_widths;
};

inline double width(const Limits& range) {
  return range.upper - range.lower;
}

/// All values of the path.
JointBox wholeBox(const JointPath& path);

/// The half with smaller values of the variable, and the other one.
std::array<JointBox, 2> halves(const JointBox& box, std::size_t variable);

/// The volume of `box` as a share of the whole box of the path, from 0 to 1.
double shareOf(const JointBox& box, const JointPath& path);

}  // namespace link_bounds

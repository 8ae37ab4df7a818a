// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The joints between two links as one chain, seen from the first link, and boxes of the values of
// these joints. No other joint changes the relative pose of the two links.
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

/// A joint that can move. Joints on the way up to the common ancestor are passed from child to
/// parent.
struct PathJoint {
  Eigen::Isometry3d before;  ///< pose in the frame of the joint before, or of the first link
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

/// Fixed joints, and those whose range is one value, are part of the transforms between the others.
struct JointPath {
  std::vector<std::size_t> variables;  ///< joints of the robot that move and mimic no other one
  std::vector<Limits> ranges;          ///< one per variable
  std::vector<std::size_t> unknown;    ///< joints of the robot on the path, without known ranges
  /// The values of joints on which the path depends and that cannot move, if not 0 [rad or m].
  std::map<std::size_t, double> resting;
  std::vector<PathJoint> joints;                            ///< from the first link to the second
  Eigen::Isometry3d after = Eigen::Isometry3d::Identity();  ///< from the last joint to the second
  double length = 0;  ///< sum of all link offsets and the max |value| of each prismatic joint [m]
  std::size_t count = 0;  ///< number of joints of any kind

  /// True if several joints depend on the variable.
  bool isShared(std::size_t variable) const;

  /// The pose of the second link in the frame of the first.
  Eigen::Isometry3d pose(const PathValues& values) const;

  void place(const PathValues& values, PlacedPath& placed) const;
};

/// `ranges` has one per joint of the robot.
JointPath jointPath(const Robot& robot, const std::vector<JointRange>& ranges, std::size_t first,
                    std::size_t second);

/// A box of joint values: those that differ from the centre by at most the half widths.
struct JointBox {
  PathValues center;
  PathValues half_widths;
};

inline double width(const Limits& range) {
  return range.upper - range.lower;
}

/// The box of the whole ranges of the path.
JointBox wholeBox(const JointPath& path);

/// The half with smaller values of the variable, and the other one.
std::array<JointBox, 2> halves(const JointBox& box, std::size_t variable);

/// The volume of `box` as a share of the whole box of the path, from 0 to 1.
double shareOf(const JointBox& box, const JointPath& path);

}  // namespace link_bounds

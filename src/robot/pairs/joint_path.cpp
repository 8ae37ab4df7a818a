// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Up from the first link to the common ancestor, then down to the second one.
#include "robot/pairs/joint_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/urdf/joints_above.h"

namespace link_bounds {
namespace {

class PathBuilder {
 public:
  PathBuilder(const Robot& robot, const std::vector<JointRange>& ranges)
      : robot_(robot), ranges_(ranges) {}

  void goUp(std::size_t joint) {
    addMotion(joint, -1);
    addFixed(robot_.joints[joint].parent_from_joint.inverse());
  }

  void goDown(std::size_t joint) {
    addFixed(robot_.joints[joint].parent_from_joint);
    addMotion(joint, 1);
  }

  JointPath result() {
    path_.after = fixed_;
    return path_;
  }

 private:
  void addFixed(const Eigen::Isometry3d& transform) {
    path_.length += transform.translation().norm();
    fixed_ = fixed_ * transform;
  }

  void addMotion(std::size_t index, double sign) {
    const Joint& joint = robot_.joints[index];
    const JointRange& range = ranges_[index];
    ++path_.count;
    if (!range.is_known) path_.unknown.push_back(index);
    if (joint.motion == Motion::kNone) return;
    if (joint.motion == Motion::kTranslation)
      path_.length += std::max(std::abs(range.lower), std::abs(range.upper));
    if (!range.isFree()) {
      const Lead& lead = range.lead;
      const double value = ranges_[lead.leader].lower;
      if (lead.factor != 0 && value != 0) path_.resting[lead.leader] = value;
      fixed_ = fixed_ * jointMotion(joint, sign * range.lower);
      return;
    }
    if (joint.axis.isZero(0)) {
      throw JointError("joint \"" + joint.name +
                       "\" cannot move, its axis is zero; correct the axis, or leave it at 0");
    }
    path_.joints.push_back({fixed_, joint.motion, joint.axis, variableOf(range.lead.leader),
                            sign * range.lead.factor, sign * range.lead.offset});
    fixed_.setIdentity();
  }

  std::size_t variableOf(std::size_t leader) {
    const auto found = std::find(path_.variables.begin(), path_.variables.end(), leader);
    const auto index = static_cast<std::size_t>(found - path_.variables.begin());
    if (found != path_.variables.end()) return index;
    path_.variables.push_back(leader);
    path_.ranges.push_back({ranges_[leader].lower, ranges_[leader].upper});
    return index;
  }

  const Robot& robot_;
  const std::vector<JointRange>& ranges_;
  JointPath path_;
  Eigen::Isometry3d fixed_ = Eigen::Isometry3d::Identity();  ///< since the last joint that moves
};

}  // namespace

Eigen::Isometry3d PathJoint::motionAt(const PathValues& values) const {
  return jointMotion(motion, axis, factor * values[variable] + offset);
}

bool JointPath::isShared(std::size_t variable) const {
  return std::count_if(joints.begin(), joints.end(),
                       [&](const PathJoint& joint) { return joint.variable == variable; }) > 1;
}

Eigen::Isometry3d JointPath::pose(const PathValues& values) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (const PathJoint& joint : joints)
    result = result * joint.before * joint.motionAt(values);
  return result * after;
}

void JointPath::place(const PathValues& values, PlacedPath& placed) const {
  placed.axes.resize(joints.size());
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const PathJoint& joint = joints[j];
    at = at * joint.before;
    placed.axes[j] = {at.translation(), at.linear() * joint.axis};
    at = at * joint.motionAt(values);
  }
  placed.first_from_second = at * after;
}

JointPath jointPath(const Robot& robot, const std::vector<JointRange>& ranges, std::size_t first,
                    std::size_t second) {
  std::vector<std::size_t> up = jointsAbove(robot, first);
  std::vector<std::size_t> down = jointsAbove(robot, second);
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  PathBuilder builder(robot, ranges);
  for (const std::size_t joint : up)
    builder.goUp(joint);
  for (auto joint = down.rbegin(); joint != down.rend(); ++joint)
    builder.goDown(*joint);
  return builder.result();
}

JointBox wholeBox(const JointPath& path) {
  JointBox all;
  for (const Limits& range : path.ranges) {
    all.center.push_back(range.lower + width(range) / 2);
    all.half_widths.push_back(
        std::nextafter(width(range) / 2, std::numeric_limits<double>::infinity()));
  }
  return all;
}

std::array<JointBox, 2> halves(const JointBox& box, std::size_t variable) {
  std::array<JointBox, 2> result{box, box};
  const double half = box.half_widths[variable] / 2;
  result[0].half_widths[variable] = result[1].half_widths[variable] = half;
  result[0].center[variable] -= half;
  result[1].center[variable] += half;
  return result;
}

double shareOf(const JointBox& box, const JointPath& path) {
  double share = 1;
  for (std::size_t v = 0; v < path.ranges.size(); ++v)
    share *= 2 * box.half_widths[v] / width(path.ranges[v]);
  return share;
}

}  // namespace link_bounds

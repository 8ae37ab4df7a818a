// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the link to the root, then in the other order.
#include "robot/reach/chain.h"

#include <algorithm>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/urdf/joints_above.h"

namespace link_bounds {
namespace {

/// The index of the variable of that joint; adds it if it is new.
std::size_t variableOf(const std::vector<JointRange>& ranges, std::size_t joint, Chain& chain) {
  const auto is_it = [&](const ChainVariable& variable) { return variable.joint == joint; };
  const auto known = std::find_if(chain.variables.begin(), chain.variables.end(), is_it);
  const auto index = static_cast<std::size_t>(known - chain.variables.begin());
  if (known != chain.variables.end()) {
    chain.variables[index].is_shared = true;
  } else {
    chain.variables.push_back({joint, {ranges[joint].lower, ranges[joint].upper}, false});
  }
  return index;
}

}  // namespace

Eigen::Isometry3d Chain::pose(const std::vector<double>& values) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (const ChainJoint& joint : joints) {
    const double value = joint.factor * values[joint.variable] + joint.offset;
    result = result * joint.before * jointMotion(*joint.source, value);
  }
  return result * end;
}

Chain chainTo(const Robot& robot, const std::vector<JointRange>& ranges, std::size_t link) {
  Chain chain;
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  const std::vector<std::size_t> above = jointsAbove(robot, link);
  chain.length = above.size();
  for (auto index = above.rbegin(); index != above.rend(); ++index) {
    const Joint& joint = robot.joints[*index];
    const JointRange& range = ranges[*index];
    before = before * joint.parent_from_joint;
    if (joint.motion == Motion::kNone) continue;
    if (!range.isFree()) {
      before = before * jointMotion(joint, range.lower);
      continue;
    }
    const std::size_t variable = variableOf(ranges, range.lead.leader, chain);
    chain.joints.push_back({before, &joint, variable, range.lead.factor, range.lead.offset});
    before = Eigen::Isometry3d::Identity();
  }
  chain.end = before;
  return chain;
}

}  // namespace link_bounds

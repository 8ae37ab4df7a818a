// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The rotation of URDF's rpy is Rz(yaw) Ry(pitch) Rx(roll), so yaw comes first in the chain.
#include "robot/urdf/simple_joints.h"

#include <algorithm>
#include <set>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/urdf/joints_above.h"

namespace link_bounds {
namespace {

struct Part {
  const char* name;
  Motion motion;
  Eigen::Vector3d axis;  ///< in the frame of the joint
};

using Parts = std::vector<Part>;

Parts partsOfFloating() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  return {{"x", Motion::kTranslation, x},  {"y", Motion::kTranslation, y},
          {"z", Motion::kTranslation, z},  {"yaw", Motion::kRotation, z},
          {"pitch", Motion::kRotation, y}, {"roll", Motion::kRotation, x}};
}

/// Without an axis, no part has one.
Parts partsOfPlanar(const Eigen::Vector3d& normal) {
  Eigen::Index nearest = 0;
  normal.cwiseAbs().maxCoeff(&nearest);
  Eigen::Vector3d x = Eigen::Vector3d::Unit((nearest + 1) % 3);
  x = normal.isZero(0) ? normal : (x - normal * normal.dot(x)).normalized();
  return {{"x", Motion::kTranslation, x},
          {"y", Motion::kTranslation, normal.cross(x)},
          {"yaw", Motion::kRotation, normal}};
}

Parts partsOf(const Joint& joint) {
  if (joint.motion == Motion::kFloating) return partsOfFloating();
  if (joint.motion == Motion::kPlanar) return partsOfPlanar(joint.axis);
  return {};
}

/// The last part moves the child of the joint.
void addParts(const Joint& whole, const Parts& parts, Robot& robot) {
  std::size_t parent = whole.parent;
  for (const Part& part : parts) {
    const bool is_first = &part == &parts.front();
    const bool is_last = &part == &parts.back();
    Joint joint;
    joint.name = whole.name + "." + part.name;
    joint.parent = parent;
    joint.child = is_last ? whole.child : robot.links.size();
    joint.motion = part.motion;
    joint.parent_from_joint = is_first ? whole.parent_from_joint : Eigen::Isometry3d::Identity();
    joint.axis = part.axis;
    joint.part_of = whole.name;
    if (!is_last) robot.links.push_back({joint.name, {}, {}});
    parent = joint.child;
    robot.joints.push_back(std::move(joint));
  }
}

/// The message about the name of a floating or planar joint, which has more than one value; "" for
/// other names.
std::string whyNotWhole(const Robot& robot, const std::string& name) {
  std::string parts;
  for (const Joint& joint : robot.joints) {
    if (!name.empty() && joint.part_of == name) parts += (parts.empty() ? " " : ", ") + joint.name;
  }
  return parts.empty() ? "" : "joint \"" + name + "\" has more than one value; give" + parts;
}

const Joint* findMovable(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(
      robot.joints.begin(), robot.joints.end(),
      [&](const Joint& joint) { return hasValue(joint.motion) && joint.name == name; });
  return found == robot.joints.end() ? nullptr : &*found;
}

void checkNames(const Robot& robot) {
  std::set<std::string> names;
  for (const Joint& joint : robot.joints) {
    if (names.insert(joint.name).second) continue;
    throw JointError("two joints are called \"" + joint.name +
                     "\", one of them is a part of a floating or planar joint; rename the other");
  }
}

}  // namespace

Robot withSimpleJoints(const Robot& robot) {
  Robot result = robot;
  result.joints.clear();
  for (const Joint& joint : robot.joints) {
    const Parts parts = partsOf(joint);
    if (parts.empty()) result.joints.push_back(joint);
    addParts(joint, parts, result);
  }
  checkNames(result);
  return result;
}

bool movesBase(const Robot& robot, std::size_t joint) {
  const std::string& whole = robot.joints[joint].part_of;
  const std::vector<std::size_t> above = jointsAbove(robot, robot.joints[joint].parent);
  return !whole.empty() && std::all_of(above.begin(), above.end(), [&](std::size_t i) {
    return robot.joints[i].motion == Motion::kNone || robot.joints[i].part_of == whole;
  });
}

std::vector<std::size_t> settableJoints(const Robot& robot) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (hasValue(robot.joints[i].motion) && !robot.joints[i].mimic) result.push_back(i);
  }
  return result;
}

std::string settableNames(const Robot& robot) {
  std::string names;
  for (const std::size_t joint : settableJoints(robot))
    names += " " + robot.joints[joint].name;
  return names.empty() ? " none" : names;
}

std::string whyNoJoint(const Robot& robot, const std::string& name) {
  if (findMovable(robot, name)) return "";
  const std::string parts = whyNotWhole(robot, name);
  if (!parts.empty()) return parts;
  return "\"" + name +
         "\" is no movable joint of the robot; those that can be set:" + settableNames(robot);
}

const Joint& movableJoint(const Robot& robot, const std::string& name) {
  return *findMovable(robot, name);
}

std::string whyIgnored(const Joint& joint) {
  return "the value given for joint \"" + joint.name + "\" is ignored, it mimics joint \"" +
         joint.mimic->joint + "\"";
}

std::string missingRanges(const Robot& robot, std::vector<std::size_t> joints) {
  std::sort(joints.begin(), joints.end());
  std::string names;
  std::string ranges;
  bool is_base = false;
  for (const std::size_t index : joints) {
    const Joint& joint = robot.joints[index];
    const std::string whole = "\"" + (joint.part_of.empty() ? joint.name : joint.part_of) + "\"";
    if (names.find(whole) == std::string::npos) names += (names.empty() ? "" : ", ") + whole;
    ranges += " " + joint.name + ":=-1..1";
    is_base = is_base || movesBase(robot, index);
  }
  return "it depends on " + names + ", whose range is not given; give it, as in" + ranges +
         (is_base ? ", or --base fixed" : "");
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each refusal says what could be given instead.
#include "tools/urdf_bounds/input.h"

#include <locale>
#include <sstream>

#include "link_bounds/robot/urdf/kinematics.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"

namespace link_bounds {
namespace {

void checkNames(const Robot& robot, const std::map<std::string, double>& given) {
  std::map<std::string, const Joint*> movable;
  std::string names;
  for (const Joint& joint : robot.joints) {
    if (joint.motion == Motion::kNone) continue;
    movable.emplace(joint.name, &joint);
    if (!joint.mimic) names += " " + joint.name;
  }
  for (const auto& [name, value] : given) {
    const auto found = movable.find(name);
    if (found == movable.end()) {
      throw UsageError("\"" + name + "\" is no movable joint of the robot; those that can be set:" +
                       (names.empty() ? " none" : names));
    }
    if (found->second->mimic) {
      warn("the value given for joint \"" + name + "\" is ignored, it mimics joint \"" +
           found->second->mimic->joint + "\"");
    }
  }
}

/// One warning for all of them.
void checkLimits(const Robot& robot, const std::map<std::string, double>& given) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  for (const Joint& joint : robot.joints) {
    const auto found = given.find(joint.name);
    if (found == given.end() || joint.mimic || !joint.limits) continue;
    const auto [lower, upper] = *joint.limits;
    if (found->second >= lower && found->second <= upper) continue;
    text << (text.tellp() > 0 ? ", \"" : "\"") << joint.name << "\" at " << found->second
         << " (limits " << lower << " to " << upper << ")";
  }
  if (text.tellp() > 0)
    warn("beyond the limits of its joint in the URDF: " + text.str() +
         "; the boxes are those of this pose all the same");
}

}  // namespace

std::vector<Eigen::Isometry3d> posesFor(const Robot& robot,
                                        const std::map<std::string, double>& given) {
  checkNames(robot, given);
  checkLimits(robot, given);
  return linkPoses(robot, jointValues(robot, given));
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each refusal says what the user can give instead.
#include "tools/urdf_bounds/request/input.h"

#include <algorithm>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/urdf/limit_warnings.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/command_line/text_file.h"

namespace link_bounds {
namespace {

/// A hint to the parts of a floating or planar joint that can be given; "" for other names.
std::string partsGiven(const Robot& robot, const std::string& name) {
  const bool has_parts =
      std::any_of(robot.joints.begin(), robot.joints.end(),
                  [&](const Joint& joint) { return !name.empty() && joint.part_of == name; });
  if (!has_parts) return "";
  return ", or some of them, as in " + name + ".x:=0.5 or, with --reach and --pairs, " + name +
         ".x:=-1..1";
}

void checkNames(const Robot& robot, const GivenRanges& given) {
  for (const auto& [name, range] : given) {
    const std::string reason = whyNoJoint(robot, name);
    if (!reason.empty()) throw UsageError(reason + partsGiven(robot, name));
    const Joint& joint = movableJoint(robot, name);
    if (joint.mimic) warn(whyIgnored(joint));
  }
}

/// One warning about all joints in `beyond`. `subject` says what holds all the same.
void warnOfLimits(const std::string& beyond, const std::string& subject) {
  if (!beyond.empty()) warn(beyond + "; " + subject + " all the same");
}

/// Floating and planar joints of the root do not move.
void fixBase(const Robot& robot, GivenRanges& given) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (!movesBase(robot, i)) continue;
    const std::string& name = robot.joints[i].name;
    if (!given.emplace(name, Limits{0, 0}).second)
      throw UsageError("--base fixed keeps \"" + name + "\" at 0; give only one of the two");
  }
}

}  // namespace

std::vector<double> valuesFor(const Robot& robot, const GivenRanges& given,
                              bool refuses_beyond_limits) {
  checkNames(robot, given);
  const std::string beyond = beyondLimits(robot, given);
  if (refuses_beyond_limits && !beyond.empty())
    throw UsageError(beyond + "; --strict accepts only values within them");
  warnOfLimits(beyond, "these values count");
  std::map<std::string, double> values;
  for (const auto& [name, range] : given)
    values.emplace(name, range.lower);
  return jointValues(robot, values);
}

std::vector<JointRange> rangesFor(const Robot& robot, GivenRanges given, bool has_fixed_base) {
  checkNames(robot, given);
  if (has_fixed_base) fixBase(robot, given);
  warnOfLimits(beyondLimits(robot, given), "the proof is about these values");
  const std::string equal = equalLimits(robot, given);
  if (!equal.empty()) warn(equal);
  return jointRanges(robot, given);
}

Srdf readSrdf(const std::optional<std::string>& file, const Robot& robot) {
  if (!file) return {};
  const std::string text = readText(*file, "a SRDF");
  Srdf srdf{text, parseSrdf(text, robot, *file)};
  const std::string warning = otherRobotWarning(text, robot, *file);
  if (!warning.empty()) warn(warning);
  return srdf;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes the range of each joint from that of its leader.
#include "robot/urdf/joint_ranges.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "link_bounds/robot/urdf/kinematics.h"

namespace link_bounds {
namespace {

using JointIndex = std::unordered_map<std::string, std::size_t>;

constexpr double kTurn = 2 * M_PI;

/// A range that is shorter than a turn only by the rounding of pi is a full turn [rad].
constexpr double kTurnRounding = 1e-12;

std::size_t leaderOf(const Robot& robot, const Joint& joint, const JointIndex& index) {
  const auto leader = index.find(joint.mimic->joint);
  if (leader != index.end()) return leader->second;
  const auto is_part = [&](const Joint& other) {
    return !other.part_of.empty() && other.part_of == joint.mimic->joint;
  };
  const bool has_parts = std::any_of(robot.joints.begin(), robot.joints.end(), is_part);
  throw JointError("joint \"" + joint.name + "\" mimics \"" + joint.mimic->joint + "\", which " +
                   (has_parts ? "has more than one value; let it mimic a joint with one value"
                              : "is no joint of the robot; correct its <mimic>"));
}

Lead leadOf(const Robot& robot, const JointIndex& index, std::size_t joint) {
  Lead lead{joint};
  for (std::size_t steps = 0; robot.joints[lead.leader].mimic; ++steps) {
    if (steps > robot.joints.size()) {
      throw JointError("joint \"" + robot.joints[joint].name +
                       "\" mimics in a circle; correct a <mimic> in it");
    }
    const Mimic& mimic = *robot.joints[lead.leader].mimic;
    lead.offset += lead.factor * mimic.offset;
    lead.factor *= mimic.multiplier;
    lead.leader = leaderOf(robot, robot.joints[lead.leader], index);
  }
  return lead;
}

std::string named(const Joint& joint) {
  return "joint \"" + joint.name + "\"";
}

/// What the user can do about a joint whose range cannot be used.
std::string remedyFor(const Joint& joint) {
  return "give it a range, as in " + joint.name + ":=-0.5..0.5, or a value";
}

/// A joint that follows `joint` and is elsewhere after a full turn of it; null if there is none.
const Joint* otherAfterATurn(const Robot& robot, const std::vector<Lead>& leads,
                             std::size_t joint) {
  for (std::size_t i = 0; i < leads.size(); ++i) {
    const Joint& follower = robot.joints[i];
    if (leads[i].leader != joint || !hasValue(follower.motion)) continue;
    const bool is_whole = std::trunc(leads[i].factor) == leads[i].factor;
    if (follower.motion == Motion::kTranslation || !is_whole) return &follower;
  }
  return nullptr;
}

/// The range of a rotation without limits: one turn. Throws if a joint that follows it is elsewhere
/// after a full turn.
Limits turnOf(const Robot& robot, const std::vector<Lead>& leads, std::size_t joint) {
  const Joint* const other = otherAfterATurn(robot, leads, joint);
  if (!other) return {-M_PI, M_PI};
  throw JointError(named(robot.joints[joint]) + " has no limits, and " + named(*other) +
                   " that mimics it is elsewhere after a full turn; " +
                   remedyFor(robot.joints[joint]));
}

/// The limits of a joint that moves and mimics no other one.
Limits limitsOf(const Robot& robot, const std::vector<Lead>& leads, std::size_t joint) {
  const Joint& source = robot.joints[joint];
  if (!source.limits && source.motion == Motion::kRotation) return turnOf(robot, leads, joint);
  if (!source.limits) throw JointError(named(source) + " has no limits; " + remedyFor(source));
  const auto [lower, upper] = *source.limits;
  if (std::isnan(lower) || std::isnan(upper)) {
    throw JointError("a limit of " + named(source) + " is no number (nan); " + remedyFor(source));
  }
  if (lower > upper) {
    throw JointError("the lower limit of " + named(source) + " is above its upper limit; " +
                     remedyFor(source));
  }
  if (std::isfinite(lower) && std::isfinite(upper)) return *source.limits;
  if (source.motion == Motion::kRotation && lower < upper) return turnOf(robot, leads, joint);
  throw JointError("a limit of " + named(source) + " is infinite; " + remedyFor(source));
}

/// Whether the range of a joint that mimics no other one is known.
bool isKnown(const Joint& joint, const GivenRanges& given) {
  const bool is_unlimited = joint.motion == Motion::kTranslation && !joint.part_of.empty();
  if (is_unlimited) return given.count(joint.name) > 0;
  return joint.motion != Motion::kPlanar && joint.motion != Motion::kFloating;
}

/// The range of a leader; 0 to 0 if nothing is known.
Limits leaderRange(const Robot& robot, const std::vector<Lead>& leads, const GivenRanges& given,
                   std::size_t joint) {
  const Joint& source = robot.joints[joint];
  if (source.motion == Motion::kNone || !isKnown(source, given)) return {0, 0};
  const auto found = given.find(source.name);
  const Limits range = found != given.end() ? found->second : limitsOf(robot, leads, joint);
  if (!(std::isfinite(range.lower) && std::isfinite(range.upper) && range.lower <= range.upper)) {
    throw JointError("the range given for " + named(source) + " is none; " + remedyFor(source));
  }
  return range;
}

void checkAxis(const Joint& joint, const JointRange& range, const std::string& leader) {
  if (!hasValue(joint.motion) || !joint.axis.isZero(0)) return;
  if (range.lower == 0 && range.upper == 0) return;
  throw JointError(named(joint) + " cannot move, its axis is zero; correct the axis, or give " +
                   leader + ":=0");
}

void checkNames(const Robot& robot, const GivenRanges& given) {
  for (const auto& [name, range] : given) {
    const auto is_it = [&name = name](const Joint& joint) {
      return joint.name == name && hasValue(joint.motion);
    };
    if (std::none_of(robot.joints.begin(), robot.joints.end(), is_it))
      throw JointError("\"" + name + "\" is no movable joint of the robot");
  }
}

/// One turn around 0 where the range allows it, because values near 0 are the most exact.
Limits oneTurn(const Limits& range) {
  const double middle = std::min(std::max(0.0, range.lower + M_PI), range.upper - M_PI);
  return {std::max(range.lower, middle - M_PI), std::min(range.upper, middle + M_PI)};
}

}  // namespace

std::vector<Lead> leadsOf(const Robot& robot) {
  JointIndex index;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    index.emplace(robot.joints[i].name, i);
  std::vector<Lead> leads;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    leads.push_back(leadOf(robot, index, i));
  return leads;
}

std::vector<JointRange> jointRanges(const Robot& robot, const GivenRanges& given) {
  checkNames(robot, given);
  const std::vector<Lead> leads = leadsOf(robot);
  std::vector<JointRange> ranges;
  for (std::size_t i = 0; i < leads.size(); ++i) {
    const Lead& lead = leads[i];
    const Joint& joint = robot.joints[i];
    const Limits of_leader = leaderRange(robot, leads, given, lead.leader);
    const auto [lower, upper] = std::minmax(
        {lead.factor * of_leader.lower + lead.offset, lead.factor * of_leader.upper + lead.offset});
    JointRange range{lower, upper, lead};
    range.is_known = isKnown(robot.joints[lead.leader], given) && isKnown(joint, given);
    range.is_full_turn =
        joint.motion == Motion::kRotation && upper - lower >= kTurn - kTurnRounding;
    if (range.is_full_turn && lead.leader == i && !otherAfterATurn(robot, leads, i)) {
      const Limits turn = oneTurn({lower, upper});
      range.lower = turn.lower;
      range.upper = turn.upper;
    }
    checkAxis(joint, range, robot.joints[lead.leader].name);
    ranges.push_back(range);
  }
  return ranges;
}

}  // namespace link_bounds

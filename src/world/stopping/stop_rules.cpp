// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/stopping/stop_rules.h"

#include <algorithm>
#include <cmath>

#include "link_bounds/robot/urdf/kinematics.h"

namespace link_bounds {
namespace {

using Values = std::map<std::string, double>;

std::vector<Lead> leadsWhereKnown(const Robot& robot) {
  try {
    return leadsOf(robot);
  } catch (const JointError&) {
    std::vector<Lead> leads;  // an invalid mimic: every joint is its own leader
    for (std::size_t i = 0; i < robot.joints.size(); ++i)
      leads.push_back({i});
    return leads;
  }
}

class RuleMaker {
 public:
  explicit RuleMaker(const Model& model)
      : robot_(*model.robot), parameters_(model.parameters), leads_(leadsWhereKnown(robot_)) {}

  JointRule make(std::size_t index) const {
    const Joint& joint = robot_.joints[index];
    JointRule rule{&joint, leads_[index], &leader(index), {0}, "", "", limits(index)};
    const std::string name = "joint \"" + joint.name + "\"";
    const std::string no_limit = name + " has no limit of its velocity; add it to the URDF";
    if (joint.motion == Motion::kNone) return rule;
    if (!hasValue(joint.motion)) rule.why_no_speed_limit = name + " has no limit of its velocity";
    if (!hasValue(joint.motion) || joint.axis.isZero(0)) return rule;
    rule.braking = {given(parameters_.deceleration, index).value_or(0),
                    given(parameters_.acceleration, index), maxSpeed(index)};
    if (!rule.braking.max_speed) rule.why_no_speed_limit = no_limit;
    if (rule.braking.deceleration == 0) {
      rule.why_no_stop = name + " has no ~deceleration; set it";
    } else if (parameters_.during_reaction == "limit" && !rule.braking.max_speed) {
      rule.why_no_stop = no_limit + ", or set ~during_reaction to measured";
    }
    return rule;
  }

 private:
  const Joint& leader(std::size_t index) const { return robot_.joints[leads_[index].leader]; }

  /// The value for the joint; else that of its leader, times the factor between them.
  std::optional<double> given(const Values& values, std::size_t index) const {
    const auto own = values.find(robot_.joints[index].name);
    if (own != values.end()) return own->second;
    const auto of_leader = values.find(leader(index).name);
    const double factor = std::abs(leads_[index].factor);
    if (of_leader == values.end() || !(factor > 0)) return std::nullopt;
    return of_leader->second * factor;
  }

  /// A max speed of 0 counts as unknown: many descriptions have it as a placeholder.
  std::optional<double> maxSpeed(std::size_t index) const {
    const std::optional<double> of_leader = leader(index).max_speed;
    const double factor = std::abs(leads_[index].factor);
    if (!of_leader || !std::isfinite(*of_leader) || !(*of_leader * factor > 0)) return std::nullopt;
    return *of_leader * factor;
  }

  /// Nothing for swapped limits, which no value obeys, and for equal ones: a description without
  /// limits has 0 for both.
  std::optional<Limits> limits(std::size_t index) const {
    const std::optional<Limits> of_leader = leader(index).limits;
    if (!of_leader || !(of_leader->lower < of_leader->upper)) return std::nullopt;
    const Lead& lead = leads_[index];
    const auto [lower, upper] = std::minmax({lead.factor * of_leader->lower + lead.offset,
                                             lead.factor * of_leader->upper + lead.offset});
    if (!std::isfinite(lower) || !std::isfinite(upper)) return std::nullopt;
    return Limits{lower, upper};
  }

  const Robot& robot_;
  const Parameters& parameters_;
  std::vector<Lead> leads_;
};

}  // namespace

StopRules::StopRules(std::shared_ptr<const Model> model)
    : model_(std::move(model)), bodies_(rigidBodies(*model_->robot)) {
  const Robot& robot = *model_->robot;
  const RuleMaker maker(*model_);
  above_.resize(robot.links.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    rules_.push_back(maker.make(i));
    above_[robot.joints[i].child] = i;
  }
  for (const Link& link : robot.links)
    frames_.push_back(tfName(model_->parameters.tf_prefix, link.name));
  for (std::size_t i = 0; i < frames_.size(); ++i)
    links_.emplace(frames_[i], i);
}

std::optional<std::size_t> StopRules::linkOf(std::string_view frame) const {
  const auto found = links_.find(frame);
  if (found == links_.end()) return std::nullopt;
  return found->second;
}

Reaction StopRules::reaction() const {
  const Parameters& parameters = model_->parameters;
  return {parameters.reaction_time, parameters.during_reaction == "limit"};
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One transform per joint, by the kinematics of the URDF.
#include "tools/bag_bounds/scene/joint_transforms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "link_bounds/robot/urdf/kinematics.h"
#include "world/model/model.h"

namespace link_bounds {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// From this turn on [rad], two orientations do not show in which direction a joint turned.
constexpr double kHalfTurn = kPi - 1e-6;
constexpr double kMaxStep = kPi / 2;  // rad; tf2 interpolates the shorter way
constexpr double kMaxTurn = 1e3;      // rad; larger turns are not split into steps

/// Whether both angles are within one turn: drivers may wrap the angle of a continuous joint.
bool isOfOneTurn(double a, double b) {
  const double rounding = 1e-3;
  const auto [low, high] = std::minmax(a, b);
  return (low >= -kPi - rounding && high <= kPi + rounding) ||
         (low >= -rounding && high <= 2 * kPi + rounding);
}

}  // namespace

JointTransforms::JointTransforms(Robot robot, const std::string& tf_prefix)
    : robot_(std::move(robot)) {
  for (const Link& link : robot_.links)
    frames_.push_back(tfName(tf_prefix, link.name));
  for (const Joint& joint : robot_.joints)
    joints_.emplace(joint.name, &joint);
  const std::vector<Lead> leads = leadsOf(robot_);
  for (std::size_t i = 0; i < leads.size(); ++i) {
    const Joint& leader = robot_.joints[leads[i].leader];
    if (!hasValue(robot_.joints[i].motion) || !hasValue(leader.motion)) continue;
    is_met_[leader.name] = false;
  }
}

std::vector<TransformView> JointTransforms::fixed() const {
  std::vector<TransformView> result;
  for (const Joint& joint : robot_.joints) {
    if (joint.motion == Motion::kNone) result.push_back(transformOf(joint, 0, ros::Time()));
  }
  return result;
}

std::vector<TransformView> JointTransforms::of(const sensor_msgs::JointState& message,
                                               ros::Time stamp) {
  std::vector<TransformView> result;
  Values told;
  for (std::size_t i = 0; i < message.name.size(); ++i)
    told.emplace(message.name[i], message.position[i]);
  for (auto& [name, is_met] : is_met_)
    is_met |= told.count(name) > 0;
  for (const Joint& joint : robot_.joints) {
    const std::optional<Position> position = positionOf(joint, told, stamp);
    if (!position) continue;
    if (joint.motion == Motion::kRotation) addTurn(joint, *position, result);
    result.push_back(transformOf(joint, position->value, stamp));
  }
  return result;
}

/// Adds transforms on the way of a turn by half a turn or more, so that tf2 follows its direction.
/// Leaves out positions that are not finite, and those that are older than the last one.
void JointTransforms::addTurn(const Joint& joint, const Position& next,
                              std::vector<TransformView>& result) {
  if (!std::isfinite(next.value)) return;
  const auto [entry, is_new] = last_.try_emplace(&joint, next);
  if (is_new || next.stamp <= entry->second.stamp) return;
  const Position last = std::exchange(entry->second, next);
  const Way way = wayBetween(joint, last, next);
  if (std::abs(way.turn) > kHalfTurn && std::abs(way.turn) <= kMaxTurn) {
    const double steps = std::ceil(std::abs(way.turn) / kMaxStep);
    const ros::Duration passed = next.stamp - last.stamp;
    for (int i = 1; i < steps; ++i)
      result.push_back(transformOf(joint, last.value + way.turn * (i / steps),
                                   last.stamp + passed * (i / steps)));
  }
  const bool is_known = way.is_sure && !(std::abs(way.turn) > kMaxTurn);
  if (!is_known && ambiguous_++ == 0) first_ambiguous_ = joint.name;
}

/// A joint turns as far as its leader, times the factor. Drivers may wrap the angle of a continuous
/// leader. If such an angle changes by half a turn or more, the shorter direction is assumed; it
/// counts as sure only up to a quarter of a turn, and if the factor is a whole number.
JointTransforms::Way JointTransforms::wayBetween(const Joint& joint, const Position& last,
                                                 const Position& next) {
  const bool is_of_leader = last.leader == next.leader;
  const Joint& told = is_of_leader ? *next.leader : joint;
  const double from = is_of_leader ? last.of_leader : last.value;
  const double to = is_of_leader ? next.of_leader : next.value;
  const double factor = is_of_leader ? next.factor : 1;
  const bool may_begin_anew = told.motion == Motion::kRotation && !told.limits &&
                              std::abs(to - from) > kHalfTurn && isOfOneTurn(from, to);
  if (!may_begin_anew) return {factor * (to - from), true};
  const double shorter = std::remainder(to - from, 2 * kPi);
  const bool is_whole = factor == std::round(factor);  // else a turn of the leader moves it
  if (!is_whole) return {std::remainder(next.value - last.value, 2 * kPi), false};
  return {factor * shorter, std::abs(shorter) <= kMaxStep};
}

std::string JointTransforms::loss() const {
  if (ambiguous_ == 0) return "";
  return std::to_string(ambiguous_) + (ambiguous_ == 1 ? " motion" : " motions") +
         " of joints by half a turn or more between two messages, the first of \"" +
         first_ambiguous_ +
         "\": which way round is not known, the shorter one was looked at; record joint states at "
         "a higher rate";
}

/// Follows the mimics from a joint until it finds a leader that the message has.
std::optional<JointTransforms::Position> JointTransforms::positionOf(const Joint& joint,
                                                                     const Values& told,
                                                                     ros::Time stamp) const {
  if (!hasValue(joint.motion)) return std::nullopt;
  double factor = 1, offset = 0;
  const Joint* leader = &joint;
  auto found = told.find(leader->name);
  for (; found == told.end(); found = told.find(leader->name)) {
    if (!leader->mimic) return std::nullopt;
    offset += factor * leader->mimic->offset;
    factor *= leader->mimic->multiplier;
    leader = joints_.at(leader->mimic->joint);
  }
  if (!hasValue(leader->motion)) return std::nullopt;
  return Position{leader, factor, found->second, factor * found->second + offset, stamp};
}

TransformView JointTransforms::transformOf(const Joint& joint, double value,
                                           ros::Time stamp) const {
  TransformView view(frames_[joint.parent], frames_[joint.child], "", stamp);
  const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, value);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(pose.linear()).normalized();
  const Eigen::Vector3d place = pose.translation();
  view.parent_from_child = {tf2::Quaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                            tf2::Vector3(place.x(), place.y(), place.z())};
  return view;
}

std::vector<std::string> JointTransforms::missing() const {
  std::vector<std::string> names;
  for (const auto& [name, is_met] : is_met_) {
    if (!is_met) names.push_back(name);
  }
  return names;
}

}  // namespace link_bounds

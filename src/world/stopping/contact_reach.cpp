// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The max displacement never falls with time, so bisection finds when it equals the distance.
#include "world/stopping/contact_reach.h"

#include <algorithm>
#include <cmath>

#include "link_bounds/geometry/box/aabb.h"
#include "world/stopping/edge_samples.h"

namespace link_bounds {
namespace {

constexpr double kReachRounding = 1e-9;     // relative; far above the rounding errors of until()
constexpr std::int64_t kResolution = 1000;  // ns, where bisection ends

double leverOf(const MovingJoint& joint, const Aabb& box) {
  if (joint.kind == MovingJoint::Kind::kSlide) return 0;
  double lever = 0;
  for (const Eigen::Vector3d& point : corners(box))
    lever = std::max(lever, (point - joint.origin).cross(joint.axis).norm());
  return lever;
}

}  // namespace

/// A joint without a known speed may reach its speed limit at once. At a time g from the nearest
/// transform, the joint and its interpolated value have each moved by at most max_speed * g.
ContactReach::ContactReach(const BodyWay& way, const Aabb& box, const StopRules& rules)
    : stamp_(way.stamp), begin_(way.known) {
  for (const WayJoint& joint : way.joints) {
    const JointRule& rule = rules.rule(*joint.joint);
    Step step{&rule, *joint.joint, joint.state, {}, rule.braking, 0, leverOf(joint.place, box)};
    if (joint.is_speed_known && rule.braking.acceleration)
      step.speed = speedAtStamp(joint.state, rule.braking.acceleration);
    else
      step.drive.acceleration.reset();
    step.uncertainty = 2 * *rule.braking.max_speed * joint.between;
    steps_.push_back(step);
  }
}

double ContactReach::offsetOf(const Step& step, double time) const {
  Limits offsets = travelOffsets(step.speed, step.drive, time);
  offsets.lower -= step.uncertainty;
  offsets.upper += step.uncertainty;
  offsets = withinLimits(offsets, *step.rule, step.state);
  return std::max(-offsets.lower, offsets.upper);
}

double ContactReach::until(std::int64_t time, std::size_t first) const {
  const double seconds = static_cast<double>(std::max<std::int64_t>(time - begin_, 0)) / kSecond;
  double path = 0;
  for (std::size_t i = steps_.size(); i-- > first;) {
    const Step& step = steps_[i];
    const double offset = offsetOf(step, seconds);
    path += step.rule->joint->motion == Motion::kTranslation
                ? offset
                : 2 * std::sin(std::min(offset, M_PI) / 2) * (step.lever + path);
  }
  return path * (1 + kReachRounding);
}

std::size_t ContactReach::sharedJoints(const ContactReach& other) const {
  if (stamp_ != other.stamp_) return 0;
  std::size_t count = 0;
  while (count < std::min(steps_.size(), other.steps_.size()) &&
         steps_[count].joint == other.steps_[count].joint)
    ++count;
  return count;
}

bool ContactReach::canMeet(const ContactReach& other) const {
  return std::max(steps_.size(), other.steps_.size()) > sharedJoints(other);
}

std::optional<std::int64_t> ContactReach::earliestContact(const ContactReach& other,
                                                          double distance, std::int64_t end) const {
  const std::size_t shared = sharedJoints(other);
  const auto can_touch = [&](std::int64_t time) {
    return !(until(time, shared) + other.until(time, shared) < distance);  // true for NaN
  };
  const bool this_moves = steps_.size() > shared;
  const bool other_moves = other.steps_.size() > shared;
  if (!canMeet(other) || !can_touch(end)) return std::nullopt;
  std::int64_t before = std::min(this_moves ? begin_ : end, other_moves ? other.begin_ : end);
  std::int64_t after = end;
  while (after - before > kResolution) {
    const std::int64_t middle = before + (after - before) / 2;
    (can_touch(middle) ? after : before) = middle;
  }
  return before;
}

}  // namespace link_bounds

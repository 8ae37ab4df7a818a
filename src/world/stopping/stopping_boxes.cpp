// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ignores joints that cannot move until the robot stands.
#include "world/stopping/stopping_boxes.h"

#include <cmath>

namespace link_bounds {
namespace {

/// The joints of the way with their offsets until standstill. Nothing if a number is not finite.
std::optional<std::vector<MovingJoint>> stoppingJoints(const BodyWay& way, const StopRules& rules) {
  std::vector<MovingJoint> result;
  for (const WayJoint& joint : way.joints) {
    MovingJoint moving = joint.place;
    if (joint.joint) {
      const JointRule& rule = rules.rule(*joint.joint);
      const SpeedRange speed = speedAtStamp(joint.state, rule.braking.acceleration);
      moving.offsets =
          withinLimits(stopOffsets(speed, rule.braking, rules.reaction()), rule, joint.state);
      for (const double number :
           {speed.lower, speed.upper, moving.offsets.lower, moving.offsets.upper})
        if (!std::isfinite(number)) return std::nullopt;
      if (moving.offsets.lower == 0 && moving.offsets.upper == 0) continue;
    }
    result.push_back(moving);
  }
  return result;
}

}  // namespace

WayBoxes stoppingBoxes(PastScene& scene, const StopRules& rules, const JointStates* states) {
  BodyWays ways(scene, rules, WayPurpose::kStandstill, states);
  return wayBoxes(scene, ways,
                  [&rules](const PastBody& body, const BodyWay& way) -> std::optional<Aabb> {
                    const auto joints = stoppingJoints(way, rules);
                    if (!joints) return std::nullopt;
                    return boxOfMoving(*body.bounded, way.pose, *joints);
                  });
}

}  // namespace link_bounds

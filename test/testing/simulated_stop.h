// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random stops of robots: each joint moves within what it declares until it stands.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/stopping/moving_link.h"
#include "robot/stopping/stop_offsets.h"
#include "robot/urdf/joints_above.h"
#include "testing/brute_force.h"

namespace link_bounds {

constexpr double kStopStep = 0.005;  // s, of the simulation

/// How a simulated joint may differ from what it declares: its braking distance is so much longer.
struct Brakes {
  double longer = 1;
};

/// One joint on its way to standstill: random within what it declares.
class Stop {
 public:
  Stop(double speed, const Braking& braking, const Reaction& reaction, brute_force::Random& random)
      : speed_(speed), braking_(braking), reaction_(reaction), random_(random) {}

  double offset() const { return offset_; }
  bool stands() const { return time_ >= reaction_.time && speed_ == 0; }

  /// Until the reaction ends it keeps its speed, or it speeds up or slows down at random. Then it
  /// brakes, often no harder than it must.
  void step(const Brakes& brakes) {
    const double rest = reaction_.time - time_;
    const double time = rest > 0 ? std::min(rest, kStopStep) : kStopStep;
    time_ = rest > 0 && rest <= kStopStep ? reaction_.time : time_ + time;
    const double before = speed_;
    if (rest > 0) {
      if (reaction_.may_speed_up) speedUp(time);
      offset_ += reaction_.may_speed_up ? (before + speed_) / 2 * time : before * time;
      return;
    }
    const double harder = random_.sign() > 0 ? 1 : random_.uniform(1, 3);
    const double fall = braking_.deceleration * harder / brakes.longer;
    const double end = std::max(0.0, std::abs(before) - fall * time);
    const double path = (before * before - end * end) / (2 * fall);
    offset_ += before > 0 ? path : -path;
    speed_ = before > 0 ? end : -end;
  }

 private:
  void speedUp(double time) {
    const double top = std::max(std::abs(speed_), *braking_.max_speed);
    const double change = *braking_.acceleration * time * random_.uniform(-1, 1.5);
    const double most = *braking_.acceleration * time;
    speed_ = std::min(std::max(speed_ + std::min(std::max(change, -most), most), -top), top);
  }

  double speed_;
  const Braking& braking_;
  const Reaction& reaction_;
  brute_force::Random& random_;
  double time_ = 0;
  double offset_ = 0;
};

/// What a stop of a robot starts from.
struct Start {
  std::vector<double> values;
  std::vector<double> speeds;
  std::vector<Braking> braking;
  Reaction reaction{0.1, false};
};

inline bool canMove(const Joint& joint) {
  return hasValue(joint.motion) && !joint.axis.isZero(0);
}

inline Limits limitsOf(const Joint& joint) {
  return joint.limits.value_or(Limits{-3, 3});
}

/// How far a prismatic joint may be from zero, also while it stops beyond its limits [m].
inline double farthestSlide(const Joint& joint) {
  constexpr double kStop = 1;  // a stop from the speeds of randomStart() takes less
  const Limits limits = limitsOf(joint);
  return std::max(std::abs(limits.lower), std::abs(limits.upper)) + kStop;
}

/// Along the chain, as if it were stretched.
inline std::vector<double> leversOf(const Robot& robot, const BoundedLink& link,
                                    std::size_t index) {
  std::vector<double> result(robot.joints.size(), 0);
  double length = std::sqrt(3) * magnitude(link);
  for (const std::size_t above : jointsAbove(robot, index)) {
    const Joint& joint = robot.joints[above];
    const bool slides = joint.motion == Motion::kTranslation;
    if (canMove(joint)) result[above] = slides ? 1 : length;
    length += joint.parent_from_joint.translation().norm() + (slides ? farthestSlide(joint) : 0);
  }
  return result;
}

inline Start randomStart(const Robot& robot, brute_force::Random& random) {
  Start start;
  start.reaction = {random.uniform(0, 0.2), random.sign() > 0};
  for (const Joint& joint : robot.joints) {
    const Limits limits = limitsOf(joint);
    start.values.push_back(canMove(joint) ? random.uniform(limits.lower, limits.upper) : 0);
    const double top = joint.motion == Motion::kTranslation ? 0.3 : 1.5;
    start.speeds.push_back(canMove(joint) ? random.uniform(-top, top) : 0);
    start.braking.push_back({random.uniform(2, 8), random.uniform(1, 6), top});
  }
  return start;
}

inline Limits offsetsOf(const Start& start, std::size_t joint) {
  const double speed = start.speeds[joint];
  return stopOffsets({speed, speed}, start.braking[joint], start.reaction);
}

/// The joints above a link, placed where they are at the start.
inline std::vector<MovingJoint> movingJoints(const Robot& robot, const Start& start,
                                             const std::vector<Eigen::Isometry3d>& poses,
                                             std::size_t link) {
  std::vector<MovingJoint> result;
  const std::vector<std::size_t> above = jointsAbove(robot, link);
  for (auto index = above.rbegin(); index != above.rend(); ++index) {
    const Joint& joint = robot.joints[*index];
    if (!canMove(joint)) continue;
    const Eigen::Isometry3d& pose = poses[joint.child];
    const bool turns = joint.motion == Motion::kRotation;
    result.push_back({turns ? MovingJoint::Kind::kTurn : MovingJoint::Kind::kSlide,
                      pose.translation(), pose.linear() * joint.axis, offsetsOf(start, *index)});
  }
  return result;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/motion_bound.h"

#include <algorithm>
#include <cmath>

#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

/// Relative rounding of a joint value: that of the centres after some 60 halvings of a range.
constexpr double kHalvings = 1e-14;

/// Max number of joints on one side for gapAlong(): more have too many corners.
constexpr std::size_t kMaxCornerJoints = 6;

/// A test compiles this with a smaller share, so that motions are too small. Its check of the
/// proofs has to find that.
#ifndef LINK_BOUNDS_SHARE_OF_MOTION
#define LINK_BOUNDS_SHARE_OF_MOTION 1
#endif
constexpr double kShare = LINK_BOUNDS_SHARE_OF_MOTION;

/// How far a point at distance 1 from the axis moves during a turn by `half_width` [rad].
double chordOfTurn(double half_width) {
  return 2 * std::sin(std::min(half_width, M_PI) / 2);
}

}  // namespace

MotionBound::MotionBound(const JointPath& path, const BodyCloud& first, const BodyCloud& second)
    : path_(path),
      half_widths_(path.joints.size()),
      first_{&first, Eigen::Isometry3d::Identity(), {}, {}, 0},
      second_{&second, Eigen::Isometry3d::Identity(), {}, {}, 0},
      rounding_(kPoseRounding * (path.length + first.magnitude() + second.magnitude())) {
  if (path.joints.empty()) return;
  const PathJoint& front = path.joints.front();
  const PathJoint& back = path.joints.back();
  const Eigen::Isometry3d to_second = path.after.inverse();
  first_.own_lever =
      first.farthestFrom({front.before.translation(), front.before.linear() * front.axis});
  second_.own_lever =
      second.farthestFrom({to_second.translation(), to_second.linear() * back.axis});
}

void MotionBound::set(const JointBox& box, const PlacedPath& placed) {
  placed_ = &placed;
  second_.from_body = placed.first_from_second;
  for (std::size_t j = 0; j < path_.joints.size(); ++j) {
    const PathJoint& joint = path_.joints[j];
    const std::size_t v = joint.variable;
    half_widths_[j] =
        std::abs(joint.factor) * (box.half_widths[v] + kHalvings * std::abs(box.center[v])) +
        kHalvings * std::abs(joint.offset);
  }
  chooseCut();
}

void MotionBound::measure(Side& side, std::size_t joint) {
  double move = half_widths_[joint];
  if (path_.joints[joint].motion == Motion::kRotation)
    move = chordOfTurn(move) * lever(side, joint);
  side.joints.push_back(joint);
  side.moves.push_back(kShare * move);
}

/// Upper bound of the distance of the body's points from the axis [m].
double MotionBound::lever(const Side& side, std::size_t joint) const {
  const std::size_t own = &side == &first_ ? 0 : path_.joints.size() - 1;
  if (joint == own) return side.own_lever;
  const Axis& axis = placed_->axes[joint];
  const Eigen::Isometry3d to_body = side.from_body.inverse();
  return side.body->farthestFrom({to_body * axis.origin, to_body.linear() * axis.direction});
}

/// Cuts the path where the sum of both motions is smallest. The joints before the cut move the
/// first body, the others the second one.
void MotionBound::chooseCut() {
  const std::size_t count = path_.joints.size();
  for (Side* side : {&first_, &second_}) {
    side->joints.clear();
    side->moves.clear();
    for (std::size_t j = 0; j < count; ++j)
      measure(*side, j);
  }
  double sum = 0;
  for (const double move : second_.moves)
    sum += move;
  motion_ = sum;
  std::size_t cut = 0;
  for (std::size_t j = 0; j < count; ++j) {
    sum += first_.moves[j] - second_.moves[j];
    if (!(sum < motion_)) continue;
    motion_ = sum;
    cut = j + 1;
  }
  const auto at = static_cast<std::ptrdiff_t>(cut);
  first_.joints.resize(cut);
  first_.moves.resize(cut);
  std::reverse(first_.joints.begin(), first_.joints.end());
  std::reverse(first_.moves.begin(), first_.moves.end());
  second_.joints.erase(second_.joints.begin(), second_.joints.begin() + at);
  second_.moves.erase(second_.moves.begin(), second_.moves.begin() + at);
}

std::size_t MotionBound::widestVariable() const {
  std::vector<double> sums(path_.variables.size(), 0.0);
  for (const Side* side : {&first_, &second_}) {
    for (std::size_t i = 0; i < side->joints.size(); ++i)
      sums[path_.joints[side->joints[i]].variable] += side->moves[i];
  }
  return static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
}

double MotionBound::gapAlong(const Eigen::Vector3d& normal, const BodyCloud& first,
                             const BodyCloud& second) const {
  if (std::max(first_.joints.size(), second_.joints.size()) > kMaxCornerJoints)
    return -std::numeric_limits<double>::infinity();
  return -farthestAlong(first_, first, normal) - farthestAlong(second_, second, -normal);
}

/// The largest coordinate along a unit direction that a point of the part can have in the box. The
/// sign of an offset does not matter, as each comes with both signs.
double MotionBound::farthestAlong(const Side& side, const BodyCloud& part,
                                  const Eigen::Vector3d& direction) const {
  const std::size_t count = side.joints.size();
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < (std::size_t{1} << count); ++corner) {
    Eigen::Vector3d turned = direction;
    double shift = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = side.joints[i];
      const Axis& axis = placed_->axes[j];
      const double offset = corner >> i & 1 ? half_widths_[j] : -half_widths_[j];
      if (path_.joints[j].motion == Motion::kRotation) {
        const Eigen::Vector3d turn = offset * direction.cross(axis.direction);
        turned += turn;
        shift -= turn.dot(axis.origin);
      } else {
        shift += offset * direction.dot(axis.direction);
      }
    }
    const double support = part.support(side.from_body.linear().transpose() * turned) +
                           turned.dot(side.from_body.translation());
    farthest = std::max(farthest, support + shift);
  }
  return farthest + remainder(side);
}

/// The bound of |R|, see motion_bound.h. Goes from the body outward: `beyond` is how far the joints
/// nearer to the body move a point [m].
double MotionBound::remainder(const Side& side) const {
  double sum = 0;
  double beyond = 0;
  for (std::size_t i = side.joints.size(); i-- > 0;) {
    const std::size_t inner = side.joints[i];
    const double width = half_widths_[inner];
    double speed = 1;
    if (path_.joints[inner].motion == Motion::kRotation) {
      const double chord = chordOfTurn(width);
      speed = (chord > 0 ? side.moves[i] / chord : 0) + beyond;
      sum += width * width * speed / 2;
    }
    for (std::size_t k = 0; k < i; ++k) {
      const std::size_t outer = side.joints[k];
      if (path_.joints[outer].motion == Motion::kRotation)
        sum += half_widths_[outer] * width * speed;
    }
    beyond += side.moves[i];
  }
  return sum;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds directions from the first joint to the link, then supports from the link back to the first
// joint.
#include "robot/stopping/moving_link.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "link_bounds/geometry/box/rounding.h"
#include "robot/stopping/turn_cuts.h"
#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

using Kind = MovingJoint::Kind;

/// Supports along the three rows of a matrix, and against them [m].
struct Supports {
  Eigen::Vector3d along;
  Eigen::Vector3d against;
};

double distanceFrom(const MovingJoint& joint, const Eigen::Vector3d& point) {
  return (point - joint.origin).cross(joint.axis).norm();
}

double largest(const Limits& offsets) {
  return std::max(std::abs(offsets.lower), std::abs(offsets.upper));
}

Limits withinOneTurn(const Limits& range) {
  return range.upper - range.lower < 2 * M_PI ? range : Limits{-M_PI, M_PI};
}

class MovingBox {
 public:
  MovingBox(const BoundedLink& link, const Eigen::Affine3d& pose,
            const std::vector<MovingJoint>& joints);

  std::optional<Aabb> box();

 private:
  bool placeBalls();
  void findDirections();
  bool askLink();
  void fold(std::size_t index);
  void foldTurn(const MovingStep& step, const SweptBall& ball,
                const std::vector<Eigen::Matrix3d>& parents,
                const std::vector<Eigen::Matrix3d>& children);
  void swing(const MovingStep& step, const SweptBall& ball,
             const std::vector<Eigen::Matrix3d>& parents,
             const std::vector<Eigen::Matrix3d>& children);
  void slide(const MovingStep& step, const std::vector<Eigen::Matrix3d>& directions);
  void drive(const MovingStep& step, const SweptBall& ball,
             const std::vector<Eigen::Matrix3d>& directions);
  void pad(double length);
  void clip(const SweptBall& ball, const std::vector<Eigen::Matrix3d>& directions);

  const BoundedLink& link_;
  Eigen::Affine3d pose_;
  std::vector<MovingStep> steps_;
  std::vector<SweptBall> balls_;  ///< around S after each joint, and last around the link
  std::vector<std::vector<Eigen::Matrix3d>>
      directions_;  ///< before each joint, and last for the link
  std::vector<Supports> supports_;
};

MovingBox::MovingBox(const BoundedLink& link, const Eigen::Affine3d& pose,
                     const std::vector<MovingJoint>& joints)
    : link_(link), pose_(pose) {
  for (const MovingJoint& joint : joints)
    steps_.push_back(
        {&joint, joint.kind == Kind::kTurn ? withinOneTurn(joint.offsets) : joint.offsets});
}

/// Sets balls_, around all places of the link while the joints from each one on move. False if
/// there is no box.
bool MovingBox::placeBalls() {
  const std::optional<Aabb> box = linkBox(link_, pose_);
  if (!box) return false;
  balls_.resize(steps_.size() + 1);
  balls_.back() = {box->center(), box->diagonal().norm() / 2};
  for (std::size_t i = steps_.size(); i-- > 0;) {
    const MovingJoint& joint = *steps_[i].joint;
    const Limits& offsets = steps_[i].offsets;
    const double middle = (offsets.lower + offsets.upper) / 2;
    const double half = (offsets.upper - offsets.lower) / 2;
    SweptBall ball = balls_[i + 1];
    if (joint.kind == Kind::kTurn) {
      ball.radius += chordOf(half) * distanceFrom(joint, ball.center);
      ball.center = joint.origin + Eigen::AngleAxisd(middle, joint.axis) *
                                       Eigen::Vector3d(ball.center - joint.origin);
    } else if (joint.kind == Kind::kSlide) {
      ball.radius += half;
      ball.center += middle * joint.axis;
    } else {
      ball.radius += joint.distance + chordOf(joint.turn) * (ball.center - joint.origin).norm();
    }
    balls_[i] = ball;
  }
  return true;
}

/// A row m becomes Q(-q) m, which is the row m Q(q).
void MovingBox::findDirections() {
  directions_.assign(1, {Eigen::Matrix3d::Identity()});
  for (const MovingStep& step : steps_) {
    const std::vector<Eigen::Matrix3d> before = directions_.back();
    std::vector<Eigen::Matrix3d>& after = directions_.emplace_back();
    if (step.joint->kind != Kind::kTurn) {
      after = before;
      continue;
    }
    after.reserve(before.size() * step.turns.size());
    for (const Eigen::Matrix3d& rows : before) {
      for (const Eigen::Matrix3d& turn : step.turns)
        after.push_back(rows * turn);
    }
  }
}

/// Rows of a pose are the axes of the box, so a box of the link has all six supports.
bool MovingBox::askLink() {
  for (const Eigen::Matrix3d& rows : directions_.back()) {
    Eigen::Affine3d turned = Eigen::Affine3d::Identity();
    turned.linear() = rows * pose_.linear();
    turned.translation() = rows * pose_.translation();
    const std::optional<Aabb> box = linkBox(link_, turned);
    if (!box) return false;
    supports_.push_back({box->max(), -box->min()});
  }
  return true;
}

void MovingBox::pad(double length) {
  for (Supports& supports : supports_) {
    supports.along.array() += length;
    supports.against.array() += length;
  }
}

void MovingBox::slide(const MovingStep& step, const std::vector<Eigen::Matrix3d>& directions) {
  const auto [lower, upper] = step.offsets;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d along = directions[i] * step.joint->axis;
    supports_[i].along += (lower * along).cwiseMax(upper * along);
    supports_[i].against += (-lower * along).cwiseMax(-upper * along);
  }
}

/// The path ends in the hull of all points that are no farther away than its length, in directions
/// that deviate by no more than its spread.
void MovingBox::drive(const MovingStep& step, const SweptBall& ball,
                      const std::vector<Eigen::Matrix3d>& directions) {
  const MovingJoint& joint = *step.joint;
  constexpr double kMaxAngleError = 3e-8;  // of acos, where the cosine is rounded to -1
  const auto support = [&](double cosine) {
    const double angle = std::acos(std::min(std::max(cosine, -1.0), 1.0)) - kMaxAngleError;
    return joint.distance * std::max(0.0, std::cos(std::max(0.0, angle - joint.spread)));
  };
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d cosines = directions[i] * joint.axis;
    for (Eigen::Index k = 0; k < 3; ++k) {
      supports_[i].along[k] += support(cosines[k]);
      supports_[i].against[k] += support(-cosines[k]);
    }
  }
  pad(chordOf(joint.turn) * ((ball.center - joint.origin).norm() + ball.radius));
}

/// The largest value between two angles: mean and half difference of the ends make the sinusoid.
class Between {
 public:
  explicit Between(double half_piece)
      : cosine2_(std::cos(half_piece) * std::cos(half_piece)),
        sine2_(std::sin(half_piece) * std::sin(half_piece)) {}

  double highest(double first, double last) const {
    const double mean = (first + last) / 2;
    const double half = (last - first) / 2;
    double best = std::max(first, last);
    if (std::abs(half) * cosine2_ < mean * sine2_)
      best = std::max(best, std::sqrt(mean * mean / cosine2_ + half * half / sine2_));
    return best;
  }

 private:
  double cosine2_;
  double sine2_;
};

/// Where an axis is nearest to the centre of the ball.
Eigen::Vector3d nearestOnAxis(const MovingJoint& joint, const SweptBall& ball) {
  return joint.origin + joint.axis * joint.axis.dot(ball.center - joint.origin);
}

void MovingBox::foldTurn(const MovingStep& step, const SweptBall& ball,
                         const std::vector<Eigen::Matrix3d>& parents,
                         const std::vector<Eigen::Matrix3d>& children) {
  const Eigen::Vector3d& axis = step.joint->axis;
  const Eigen::Vector3d origin = nearestOnAxis(*step.joint, ball);
  const Between between(step.half_piece);
  std::vector<Supports> result(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const Eigen::Vector3d shared = ball.radius * (parents[i] * axis).cwiseAbs();
    const Eigen::Vector3d at_origin = parents[i] * origin;
    result[i].along.setConstant(-std::numeric_limits<double>::infinity());
    result[i].against = result[i].along;
    Supports before{};
    for (std::size_t k = 0; k < step.turns.size(); ++k) {
      const std::size_t child = i * step.turns.size() + k;
      const Eigen::Vector3d shift = children[child] * origin;
      const Supports bracket{supports_[child].along - shift + shared,
                             supports_[child].against + shift + shared};
      for (Eigen::Index row = 0; k > 0 && row < 3; ++row) {
        double& along = result[i].along[row];
        double& against = result[i].against[row];
        along = std::max(along, between.highest(before.along[row], bracket.along[row]));
        against = std::max(against, between.highest(before.against[row], bracket.against[row]));
      }
      before = bracket;
    }
    result[i].along += at_origin - shared;
    result[i].against -= at_origin + shared;
  }
  supports_ = std::move(result);
}

/// Max gain of a point along a direction while it turns to both sides by up to an angle with the
/// given sine and the cosine 1 - fall. A turn by x adds along (cos x - 1) + across sin x [m].
double gainOfPoint(double along, double across, double sine, double fall) {
  const double side = std::abs(across);
  if (sine > 0 && along * sine >= side * (1 - fall)) return std::hypot(along, side) - along;
  return side * sine - along * fall;
}

/// Max gain of a set along directions whose angle to a middle one has at least the cosine 1 - fall.
/// The set is in a ball and, along the middle direction, no higher than `height` above its centre
/// [m].
double gainOfCap(double height, double radius, double fall) {
  if (radius * (1 - fall) <= height) return radius - height;
  const double side = height > 0 ? std::sqrt((radius - height) * (radius + height)) : radius;
  return side * std::sqrt(std::max(0.0, fall * (2 - fall))) - height * fall;
}

/// Uses the middle of the turn alone: the centre of the ball turns as a point, the set around it is
/// bounded as a cap.
void MovingBox::swing(const MovingStep& step, const SweptBall& ball,
                      const std::vector<Eigen::Matrix3d>& parents,
                      const std::vector<Eigen::Matrix3d>& children) {
  const Eigen::Vector3d& axis = step.joint->axis;
  const Eigen::Vector3d origin = nearestOnAxis(*step.joint, ball);
  const Eigen::Vector3d lever = ball.center - origin;
  const Eigen::Vector3d ahead = axis.cross(lever);
  const double sine = std::sin(step.half_piece);
  const double fall = chordOf(step.half_piece) * chordOf(step.half_piece) / 2;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const Eigen::Vector3d shift = (parents[i] - children[i]) * origin;
    const Eigen::Vector3d center = children[i] * ball.center;
    const Eigen::Vector3d along = children[i] * lever;
    const Eigen::Vector3d across = children[i] * ahead;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double share = children[i].row(k).cross(axis.transpose()).squaredNorm() * fall;
      double& up = supports_[i].along[k];
      double& down = supports_[i].against[k];
      up += shift[k] + gainOfPoint(along[k], across[k], sine, fall) +
            gainOfCap(up - center[k], ball.radius, share);
      down += -shift[k] + gainOfPoint(-along[k], across[k], sine, fall) +
              gainOfCap(down + center[k], ball.radius, share);
    }
  }
}

void MovingBox::fold(std::size_t index) {
  const MovingStep& step = steps_[index];
  const SweptBall& ball = balls_[index + 1];
  if (step.joint->kind == Kind::kSlide) {
    slide(step, directions_[index]);
  } else if (step.joint->kind == Kind::kFree) {
    drive(step, ball, directions_[index]);
  } else if (step.turns.size() == 1) {
    swing(step, ball, directions_[index], directions_[index + 1]);
  } else {
    foldTurn(step, ball, directions_[index], directions_[index + 1]);
  }
  clip(balls_[index], directions_[index]);
}

/// Limits the supports to those of the ball around all places of the link.
void MovingBox::clip(const SweptBall& ball, const std::vector<Eigen::Matrix3d>& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d center = directions[i] * ball.center;
    supports_[i].along = supports_[i].along.cwiseMin((center.array() + ball.radius).matrix());
    supports_[i].against = supports_[i].against.cwiseMin((ball.radius - center.array()).matrix());
  }
}

std::optional<Aabb> MovingBox::box() {
  if (!placeBalls()) return std::nullopt;
  chooseCuts(steps_, balls_);
  findDirections();
  if (!askLink()) return std::nullopt;
  for (std::size_t i = steps_.size(); i-- > 0;)
    fold(i);
  const Supports& found = supports_.front();
  if (!found.along.allFinite() || !found.against.allFinite()) return std::nullopt;
  return Aabb(-found.against, found.along);
}

/// Upper bound of all |coordinates| that occur [m].
double magnitudeOf(const Eigen::Affine3d& pose, const BoundedLink& link,
                   const std::vector<MovingJoint>& joints) {
  double sum = pose.translation().norm() + 2 * magnitude(link);
  for (const MovingJoint& joint : joints)
    sum += joint.origin.norm() + joint.distance +
           (joint.kind == Kind::kSlide ? largest(joint.offsets) : 0);
  return sum;
}

}  // namespace

/// Computes relative to the first joint, which keeps digits far from the origin of the frame.
std::optional<Aabb> boxOfMoving(const BoundedLink& link, const Eigen::Affine3d& frame_from_link,
                                const std::vector<MovingJoint>& joints) {
  if (joints.empty()) return linkBox(link, frame_from_link);
  if (!isUsablePose(frame_from_link)) return std::nullopt;
  const Eigen::Vector3d start = joints.front().origin;
  std::vector<MovingJoint> moved = joints;
  for (MovingJoint& joint : moved)
    joint.origin -= start;
  Eigen::Affine3d pose = frame_from_link;
  pose.translation() -= start;
  BoundedLink bare = link;
  bare.padding = 0;
  const std::optional<Aabb> box = MovingBox(bare, pose, moved).box();
  if (!box) return std::nullopt;
  const double count = static_cast<double>(joints.size() + 1);
  const double rounding = link.padding + kRoundoffsPerJoint * kUnitRoundoff *
                                             (count * magnitudeOf(pose, bare, moved) +
                                              start.norm() + frame_from_link.translation().norm());
  return padded(Aabb(box->min() + start, box->max() + start), rounding);
}

}  // namespace link_bounds

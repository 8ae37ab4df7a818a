// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions from the first joint to the link, then supports back.
#include "robot/stopping/moving_link.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "link_bounds/geometry/box/rounding.h"
#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

using Kind = MovingJoint::Kind;

/// A turn is cut into pieces. For a set of radius r a piece of 2 p costs up to r (1 / cos(p) - 1);
/// beyond this p it is worse than the ball around the set [rad].
constexpr double kMaxHalfPiece = 1.2;

/// Cuts that gain less are not worth their time [m].
constexpr double kMinGain = 5e-4;

/// How often the link is asked for a box. With 64, a 7-joint arm takes a quarter longer, and its
/// faces are hardly nearer; with 16, half of those of a Gen3 are 24 mm too far out.
constexpr std::size_t kMaxLeaves = 40;

/// Supports along the three rows of a matrix, and against them [m].
struct Supports {
  Eigen::Vector3d along;
  Eigen::Vector3d against;
};

struct Ball {
  Eigen::Vector3d center;
  double radius;
};

double chordOf(double angle) {
  return 2 * std::sin(std::min(std::abs(angle), M_PI) / 2);
}

double distanceFrom(const MovingJoint& joint, const Eigen::Vector3d& point) {
  return (point - joint.origin).cross(joint.axis).norm();
}

double largest(const Limits& offsets) {
  return std::max(std::abs(offsets.lower), std::abs(offsets.upper));
}

Limits withinOneTurn(const Limits& range) {
  return range.upper - range.lower < 2 * M_PI ? range : Limits{-M_PI, M_PI};
}

/// One joint, with what is common to all directions.
struct Step {
  const MovingJoint* joint;
  Limits offsets;
  std::size_t cuts = 0;                     ///< angles at which a turn is examined; 0: it pads
  std::vector<Eigen::Matrix3d> turns = {};  ///< by these angles
  double cosine2 = 1;                       ///< of half a piece, squared
  double sine2 = 0;                         ///< likewise
};

/// Fewest cuts that help: a piece must be less than half a turn.
std::size_t nextCuts(const Step& step) {
  const double width = step.offsets.upper - step.offsets.lower;
  const auto fewest = static_cast<std::size_t>(std::floor(width / (2 * kMaxHalfPiece))) + 2;
  return step.cuts == 0 ? fewest : step.cuts + 1;
}

void cut(Step& step) {
  if (step.cuts == 0) return;
  const auto pieces = static_cast<double>(step.cuts - 1);
  const double piece = (step.offsets.upper - step.offsets.lower) / pieces;
  for (std::size_t k = 0; k < step.cuts; ++k) {
    const double angle = k + 1 < step.cuts ? step.offsets.lower + piece * static_cast<double>(k)
                                           : step.offsets.upper;
    step.turns.push_back(Eigen::AngleAxisd(angle, step.joint->axis).toRotationMatrix());
  }
  step.cosine2 = std::cos(piece / 2) * std::cos(piece / 2);
  step.sine2 = std::sin(piece / 2) * std::sin(piece / 2);
}

class MovingBox {
 public:
  MovingBox(const BoundedLink& link, const Eigen::Affine3d& pose,
            const std::vector<MovingJoint>& joints);

  std::optional<Aabb> box();

 private:
  bool placeBalls();
  void chooseCuts();
  void findDirections();
  bool askLink();
  void fold(std::size_t index);
  void foldTurn(const Step& step, const Ball& ball, const std::vector<Eigen::Matrix3d>& parents,
                const std::vector<Eigen::Matrix3d>& children);
  void slide(const Step& step, const std::vector<Eigen::Matrix3d>& directions);
  void drive(const Step& step, const Ball& ball, const std::vector<Eigen::Matrix3d>& directions);
  void pad(double length);
  void clip(const Ball& ball, const std::vector<Eigen::Matrix3d>& directions);

  const BoundedLink& link_;
  Eigen::Affine3d pose_;
  std::vector<Step> steps_;
  std::vector<Ball> balls_;  ///< of S after each joint, and last of the link
  std::vector<std::vector<Eigen::Matrix3d>>
      directions_;  ///< before each joint, and last of the link
  std::vector<Supports> supports_;
};

MovingBox::MovingBox(const BoundedLink& link, const Eigen::Affine3d& pose,
                     const std::vector<MovingJoint>& joints)
    : link_(link), pose_(pose) {
  for (const MovingJoint& joint : joints)
    steps_.push_back(
        {&joint, joint.kind == Kind::kTurn ? withinOneTurn(joint.offsets) : joint.offsets});
}

/// Around all places of the link while the joints from one on move. False if there is no box.
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
    Ball ball = balls_[i + 1];
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

/// What a turn adds at most to a face beyond what is attained, about [m].
double lossOf(const Step& step, const Ball& ball, std::size_t pieces) {
  const double lever = distanceFrom(*step.joint, ball.center) + ball.radius;
  const double padding = chordOf(largest(step.offsets)) * lever;
  const double width = step.offsets.upper - step.offsets.lower;
  const double half = width / 2 / static_cast<double>(std::max<std::size_t>(pieces, 1));
  if (pieces == 0 || half >= kMaxHalfPiece) return padding;
  return std::min(padding, ball.radius * (1 / std::cos(half) - 1));
}

/// First what gains most for its share of the leaves.
void MovingBox::chooseCuts() {
  std::size_t leaves = 1;
  for (;;) {
    Step* best = nullptr;
    double best_gain = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      Step& step = steps_[i];
      if (step.joint->kind != Kind::kTurn) continue;
      const std::size_t cuts = std::max<std::size_t>(step.cuts, 1);
      const std::size_t next = nextCuts(step);
      if (leaves / cuts * next > kMaxLeaves) continue;
      const double loss = lossOf(step, balls_[i + 1], step.cuts == 0 ? 0 : step.cuts - 1);
      const double gain = loss - lossOf(step, balls_[i + 1], next - 1);
      const double rate = gain / std::log(static_cast<double>(next) / static_cast<double>(cuts));
      if (gain < kMinGain || rate <= best_gain) continue;
      best = &step;
      best_gain = rate;
    }
    if (!best) break;
    leaves = leaves / std::max<std::size_t>(best->cuts, 1) * nextCuts(*best);
    best->cuts = nextCuts(*best);
  }
  for (Step& step : steps_)
    cut(step);
}

/// A row m becomes Q(-q) m, which is the row m Q(q).
void MovingBox::findDirections() {
  directions_.assign(1, {Eigen::Matrix3d::Identity()});
  for (const Step& step : steps_) {
    const std::vector<Eigen::Matrix3d> before = directions_.back();
    std::vector<Eigen::Matrix3d>& after = directions_.emplace_back();
    if (step.cuts == 0) {
      after = before;
      continue;
    }
    after.reserve(before.size() * step.cuts);
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

void MovingBox::slide(const Step& step, const std::vector<Eigen::Matrix3d>& directions) {
  const auto [lower, upper] = step.offsets;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d along = directions[i] * step.joint->axis;
    supports_[i].along += (lower * along).cwiseMax(upper * along);
    supports_[i].against += (-lower * along).cwiseMax(-upper * along);
  }
}

/// The path ends in the hull of all points that are no farther away than its length, in directions
/// that deviate by no more than its spread.
void MovingBox::drive(const Step& step, const Ball& ball,
                      const std::vector<Eigen::Matrix3d>& directions) {
  const MovingJoint& joint = *step.joint;
  const auto support = [&](double cosine) {
    const double angle = std::acos(std::min(std::max(cosine, -1.0), 1.0));
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
double highest(double first, double last, const Step& step) {
  const double mean = (first + last) / 2;
  const double half = (last - first) / 2;
  double best = std::max(first, last);
  if (std::abs(half) * step.cosine2 < mean * step.sine2)
    best = std::max(best, std::sqrt(mean * mean / step.cosine2 + half * half / step.sine2));
  return best;
}

void MovingBox::foldTurn(const Step& step, const Ball& ball,
                         const std::vector<Eigen::Matrix3d>& parents,
                         const std::vector<Eigen::Matrix3d>& children) {
  const Eigen::Vector3d& axis = step.joint->axis;
  const Eigen::Vector3d origin =
      step.joint->origin + axis * axis.dot(ball.center - step.joint->origin);
  std::vector<Supports> result(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const Eigen::Vector3d shared = ball.radius * (parents[i] * axis).cwiseAbs();
    const Eigen::Vector3d at_origin = parents[i] * origin;
    result[i].along.setConstant(-std::numeric_limits<double>::infinity());
    result[i].against = result[i].along;
    Supports before{};
    for (std::size_t k = 0; k < step.cuts; ++k) {
      const std::size_t child = i * step.cuts + k;
      const Eigen::Vector3d shift = children[child] * origin;
      const Supports bracket{supports_[child].along - shift + shared,
                             supports_[child].against + shift + shared};
      for (Eigen::Index row = 0; k > 0 && row < 3; ++row) {
        double& along = result[i].along[row];
        double& against = result[i].against[row];
        along = std::max(along, highest(before.along[row], bracket.along[row], step));
        against = std::max(against, highest(before.against[row], bracket.against[row], step));
      }
      before = bracket;
    }
    result[i].along += at_origin - shared;
    result[i].against -= at_origin + shared;
  }
  supports_ = std::move(result);
}

void MovingBox::fold(std::size_t index) {
  const Step& step = steps_[index];
  const Ball& ball = balls_[index + 1];
  if (step.joint->kind == Kind::kSlide) {
    slide(step, directions_[index]);
  } else if (step.joint->kind == Kind::kFree) {
    drive(step, ball, directions_[index]);
  } else if (step.cuts == 0) {
    pad(chordOf(largest(step.offsets)) * (distanceFrom(*step.joint, ball.center) + ball.radius));
  } else {
    foldTurn(step, ball, directions_[index], directions_[index + 1]);
  }
  clip(balls_[index], directions_[index]);
}

/// To the ball around all places of the link.
void MovingBox::clip(const Ball& ball, const std::vector<Eigen::Matrix3d>& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d center = directions[i] * ball.center;
    supports_[i].along = supports_[i].along.cwiseMin((center.array() + ball.radius).matrix());
    supports_[i].against = supports_[i].against.cwiseMin((ball.radius - center.array()).matrix());
  }
}

std::optional<Aabb> MovingBox::box() {
  if (!placeBalls()) return std::nullopt;
  chooseCuts();
  findDirections();
  if (!askLink()) return std::nullopt;
  for (std::size_t i = steps_.size(); i-- > 0;)
    fold(i);
  const Supports& found = supports_.front();
  if (!found.along.allFinite() || !found.against.allFinite()) return std::nullopt;
  return Aabb(-found.against, found.along);
}

/// No less than any coordinate that occurs.
double magnitudeOf(const Eigen::Affine3d& pose, const BoundedLink& link,
                   const std::vector<MovingJoint>& joints) {
  double sum = pose.translation().norm() + 2 * magnitude(link);
  for (const MovingJoint& joint : joints)
    sum += joint.origin.norm() + joint.distance +
           (joint.kind == Kind::kSlide ? largest(joint.offsets) : 0);
  return sum;
}

}  // namespace

/// Far from the origin of the frame, lengths are computed from the first joint on.
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

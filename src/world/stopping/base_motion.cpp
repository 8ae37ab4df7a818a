// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The speed of a base is the max over pieces of the window, see piecesOf(), as for joints.
#include "world/stopping/base_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "world/tf/frame_paths.h"

namespace link_bounds {
namespace {

/// Smaller motions are rounding errors of the poses [m and rad].
constexpr double kStands = 1e-9;

/// If one path is shorter than this fraction of the other, its length is added in all directions.
/// That is cheaper than a spread that covers its direction, which is arbitrary for a path near 0.
constexpr double kLittle = 0.1;

/// The motion between two poses.
struct Piece {
  Eigen::Vector3d path;  ///< [m]
  double turn;           ///< between its ends [rad]
  double turned;         ///< the sum of the turns from sample to sample [rad]
  double time;           ///< rounded down [s]
};

double turnBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::Quaterniond turn(Eigen::Matrix3d(from.linear().transpose() * to.linear()));
  return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

std::vector<Piece> piecesBetween(const std::vector<TimedPose>& poses, std::int64_t window) {
  std::vector<std::int64_t> stamps;
  for (const TimedPose& pose : poses)
    stamps.push_back(pose.stamp);
  const std::vector<std::size_t> cuts = piecesOf(stamps, window);
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const TimedPose& from = poses[cuts[i - 1]];
    const TimedPose& to = poses[cuts[i]];
    double turned = 0;
    for (std::size_t k = cuts[i - 1]; k < cuts[i]; ++k)
      turned += turnBetween(poses[k].pose, poses[k + 1].pose);
    const double time = static_cast<double>(to.stamp - from.stamp) / kSecond;
    pieces.push_back({to.pose.translation() - from.pose.translation(),
                      turnBetween(from.pose, to.pose), turned,
                      std::max(time - kStampRounding, time / 2)});
  }
  return pieces;
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::optional<double> find(const Parameters& parameters, const char* name) {
  const auto found = parameters.base_deceleration.find(name);
  if (found == parameters.base_deceleration.end()) return std::nullopt;
  return found->second;
}

double stopLength(double speed, double deceleration, double reaction) {
  return (speed * reaction + speed * speed / (2 * deceleration)) * (1 + kStands);
}

/// Lets a base turn by as much as `turn`, and its path with it.
void turnUpTo(double turn, MovingJoint& joint) {
  joint.spread = std::min(joint.spread + turn - joint.turn, M_PI);
  joint.turn = turn;
}

}  // namespace

BaseMotion baseMotion(const std::vector<TimedPose>& poses, std::int64_t window,
                      const Parameters& parameters) {
  BaseMotion result;
  if (poses.size() < 2) return result;
  const std::vector<Piece> pieces = piecesBetween(poses, window);
  double speed = 0;
  double turn_speed = 0;
  bool travels = false;
  bool turns = false;
  double spread = 0;
  double max_turn = 0;  // of all pieces: along an arc, the direction differs from the chord
  const Eigen::Vector3d direction = pieces.back().path;
  for (const Piece& piece : pieces) {
    const double rounding = kStands * (1 + poses.back().pose.translation().norm() * kStands);
    const bool is_moving = piece.path.norm() > rounding;
    travels = travels || is_moving;
    turns = turns || piece.turn > kStands;
    max_turn = std::max(max_turn, piece.turn);
    turn_speed = std::max(turn_speed, piece.turn / piece.time);
    if (is_moving) spread = std::max(spread, angleBetween(direction, piece.path));
    if (piece.turned < M_PI / 2)  // the poses at the ends do not show full turns
      speed = std::max(speed, piece.path.norm() / std::cos(piece.turn / 2) / piece.time);
    else
      result.problem = "the base turns by 90 degrees or more within a piece of ~velocity_window";
  }
  if (!result.problem.empty() || (!travels && !turns)) return result;
  const std::optional<double> linear = find(parameters, "linear");
  const std::optional<double> angular = find(parameters, "angular");
  if ((travels && !linear) || (turns && !angular)) {
    result.problem = std::string("the base moves, and ~base_deceleration has no ") +
                     (travels && !linear ? "linear" : "angular") + "; set it";
    return result;
  }
  const double reaction = parameters.reaction_time;
  const bool has_direction = direction.norm() > 0;
  MovingJoint joint{
      MovingJoint::Kind::kFree, poses.back().pose.translation(),
      has_direction ? Eigen::Vector3d(direction.normalized()) : Eigen::Vector3d::UnitX()};
  joint.distance = travels ? stopLength(speed, *linear, reaction) : 0;
  joint.turn = turns ? stopLength(turn_speed, *angular, reaction) : 0;
  joint.spread = has_direction ? std::min(spread + max_turn + joint.turn, M_PI) : M_PI;
  result.joint = joint;
  return result;
}

BaseMotion around(BaseMotion motion, const BaseMotion& other, const Eigen::Isometry3d& frame) {
  if (motion.problem.empty()) motion.problem = other.problem;
  if (!other.joint) return motion;
  MovingJoint joint = *other.joint;
  joint.origin = frame * joint.origin;
  joint.axis = frame.linear() * joint.axis;
  if (!motion.joint) {
    motion.joint = joint;
    return motion;
  }
  MovingJoint& both = *motion.joint;
  const double turn = std::max(both.turn, joint.turn);
  if (joint.distance > both.distance) std::swap(joint, both);
  turnUpTo(turn, joint);
  turnUpTo(turn, both);
  if (joint.distance <= kLittle * both.distance) {
    motion.more = std::max(motion.more, joint.distance);
    return motion;
  }
  const double away = angleBetween(both.axis, joint.axis) + kStands;
  both.spread = std::min(std::max(both.spread, away + joint.spread), M_PI);
  return motion;
}

EdgeSamples pathSamples(const TransformBuffer& tf, TransformBuffer::Frame target,
                        TransformBuffer::Frame source, std::int64_t stamp, std::int64_t window) {
  EdgeSamples result;
  std::vector<std::int64_t> stamps;
  for (const TransformBuffer::Frame child : edgesBetween(tf, target, source)) {
    const EdgeSamples samples = edgeSamples(tf, child, stamp, window);
    result.problem = samples.problem;
    if (!result.problem.empty()) return result;
    for (const TimedPose& pose : samples.poses) {
      if (!samples.is_static) stamps.push_back(pose.stamp);
    }
  }
  result.is_static = stamps.empty();
  if (result.is_static) return result;
  stamps.push_back(stamp - window);
  stamps.push_back(stamp);
  std::sort(stamps.begin(), stamps.end());
  stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
  for (const std::int64_t time : stamps) {
    if (time < stamp - window || time > stamp) continue;
    const auto pose = tf.pose(target, source, time);
    Eigen::Isometry3d found;
    if (!pose || !toIsometry(*pose, found)) {
      result.problem = "the pose of frame \"" + tf.name(source) +
                       "\" is not known during all of ~velocity_window";
      return result;
    }
    result.poses.push_back({time, found});
  }
  return result;
}

}  // namespace link_bounds

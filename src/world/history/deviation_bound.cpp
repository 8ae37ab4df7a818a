// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The argument is in the header; its steps have the same numbers here.
#include "world/history/deviation_bound.h"

#include <algorithm>
#include <cmath>

#include "world/tf/tf2_pose.h"

namespace link_bounds {
namespace {

/// An angle that tf2 may treat as zero is smaller than kAngleError, so the angle that is computed
/// here is smaller than twice that.
constexpr double kJump = kAngleError;
constexpr double kMayJump = 2 * kAngleError;
constexpr double kMaxLengthJump = 1e-5;  // of squared lengths, relative; float32 rounds to 1e-7

/// Bounds the rounding errors of all poses and boxes, per edge and relative to the largest
/// coordinate. An edge takes less than 100 additions and multiplications, each wrong by 1.2e-16.
constexpr double kRounding = 5e-14;

/// q and -q are the same rotation.
bool isSameRotation(const tf2::Quaternion& a, const tf2::Quaternion& b) {
  return a == b || a == b * -1.0;
}

/// Upper bounds X, V, A and J of the header for one point.
struct PointMotion {
  double distance;
  double speed;
  double acceleration;
  double jump;
};

/// Steps 2, 3 and 6, without the translation.
PointMotion turned(const PointMotion& point, const EdgeStep& edge) {
  const double per_turn = 2 * std::sqrt(edge.length2) * edge.turn;
  const double per_turn2 = 4 * edge.turn * edge.turn;
  return {
      edge.length2 * point.distance, per_turn * point.distance + edge.length2 * point.speed,
      per_turn2 * point.distance + 2 * per_turn * point.speed + edge.length2 * point.acceleration,
      edge.length2 * (point.jump + edge.jump * point.distance)};
}

/// Step 3.
PointMotion lifted(PointMotion point, const std::vector<EdgeStep>& edges) {
  for (const EdgeStep& edge : edges) {
    point = turned(point, edge);
    point.distance += edge.distance;
    point.speed += edge.shift;
  }
  return point;
}

/// Steps 5 and 6.
PointMotion startOf(const PathSteps& path, double radius) {
  double scale = 1, slope = 0, curvature = 0, jump = 0;
  for (const auto* edges : {&path.from_link, &path.from_target}) {
    for (const EdgeStep& edge : *edges) {
      scale /= edge.min_length2;
      slope += edge.stretch;
      curvature += edge.stretch2 + edge.stretch * edge.stretch;
      jump += edge.jump;
    }
  }
  const double distance = scale * radius;
  return {distance, slope * distance, (slope * slope + curvature) * distance, jump * distance};
}

/// Bounds the distance of both points in step 4. It may be much smaller than the sum of their X: an
/// object may be near a robot that is far from the origin of the map. At the ends it is known but
/// for the lengths of the target's quaternions. Between them the origin of the link leaves the
/// straight way by at most A/8.
double separation(const PathSteps& path, const PointMotion& start, double distance,
                  double acceleration) {
  double extent = start.distance;
  for (const EdgeStep& edge : path.from_link)
    extent *= edge.length2;
  for (const EdgeStep& edge : path.from_target)
    distance /= edge.min_length2;
  return distance + acceleration / 8 + extent;
}

}  // namespace

EdgeStep EdgeStep::in(double part) const {
  EdgeStep result = *this;
  result.turn *= part;
  result.stretch *= part;
  result.stretch2 *= part * part;
  result.shift *= part;
  return result;
}

EdgeStep stepBetween(const Tf2Pose& older, const Tf2Pose& newer) {
  const tf2::Quaternion from = older.rotation(), to = newer.rotation();
  const auto [shorter, longer] = std::minmax({from.length2(), to.length2()});
  EdgeStep step;
  step.length2 = longer;
  step.min_length2 = shorter;
  step.shift = (newer.translation() - older.translation()).length();
  step.distance = std::max(older.translation().length(), newer.translation().length());
  if (isSameRotation(from, to)) return step;
  const double change = std::sqrt(longer) - std::sqrt(shorter) + kLengthError;
  const double angle = tf2::angleShortestPath(from, to);
  step.is_sudden = angle == 0;
  const double half_angle = angle / 2 + kAngleError;
  const double length_change = (longer - shorter) / shorter;
  if (angle < kMayJump) {
    step.is_jump_partial = length_change > kMaxLengthJump;
    step.jump = kJump + (step.is_jump_partial ? 0 : length_change);
  }
  step.turn = half_angle * std::sqrt(longer) + M_PI / 2 * change;
  step.stretch = step.stretch2 = 20 * change / std::sqrt(shorter);
  return step;
}

Bulge bulge(const PathSteps& path, double radius, double distance) {
  const PointMotion start = startOf(path, radius);
  PointMotion point = lifted(start, path.from_link);
  double largest = std::max(radius, point.distance);
  if (!path.from_target.empty()) {
    const PointMotion target = lifted({0, 0, 0, 0}, path.from_target);
    largest += target.distance;
    point.speed += target.speed;
    point.acceleration += target.acceleration;
    point.jump += target.jump;
    point.distance = std::min(point.distance + target.distance,
                              separation(path, start, distance, point.acceleration));
    for (auto edge = path.from_target.rbegin(); edge != path.from_target.rend(); ++edge)
      point = turned(point, *edge);
  }
  const auto edges = static_cast<double>(path.from_link.size() + path.from_target.size());
  const double rounding = kRounding * (edges + 2) * largest;
  return {point.acceleration / 8 + rounding, point.jump, rounding};
}

}  // namespace link_bounds

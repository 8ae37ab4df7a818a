// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Values of neighbouring transforms differ by less than a quarter of a turn, which makes them
// continuous.
#include "world/stopping/joint_motion.h"

#include <algorithm>
#include <cmath>

#include "robot/stopping/joint_fit.h"

namespace link_bounds {
namespace {

constexpr double kMaxMisfit = 1e-3;       // m and rad
constexpr double kMaxTurn = M_PI / 2;     // rad, between two transforms
constexpr double kValueRounding = 1e-12;  // rad or m, of the difference of two values
constexpr double kStampRounding = 1e-9;   // s, of the difference of two stamps
constexpr double kLimitRounding = 1e-9;   // rad or m
constexpr double kSecond = 1e9;           // ns

std::string misfit(const Joint& joint, const JointFit& fit) {
  if (fit.length_error <= kMaxMisfit && fit.angle_error <= kMaxMisfit) return "";
  return "a transform does not fit joint \"" + joint.name + "\": it is off by " +
         std::to_string(fit.length_error * 1e3) + " mm and " +
         std::to_string(fit.angle_error * 1e3) +
         " mrad; correct its publisher or the robot description";
}

/// Two values and the time between them.
void widen(SpeedRange& speed, bool is_first, double difference, std::int64_t nanoseconds) {
  const double time = static_cast<double>(nanoseconds) / kSecond;
  const double longest = std::abs(difference) + kValueRounding;
  const double shortest = time > 2 * kStampRounding ? time - kStampRounding : time / 2;
  const double error = longest / shortest - std::abs(difference) / time;
  const double mean = difference / time;
  speed.lower = is_first ? mean - error : std::min(speed.lower, mean - error);
  speed.upper = is_first ? mean + error : std::max(speed.upper, mean + error);
}

double fastest(double mean, double gain) {
  return std::max(mean + gain / 2, gain);
}

}  // namespace

JointState jointState(const Joint& joint, const EdgeSamples& samples, std::int64_t stamp,
                      std::int64_t window) {
  JointState state;
  const bool turns = joint.motion == Motion::kRotation;
  std::vector<double> values;
  for (const TimedPose& sample : samples.poses) {
    const JointFit fit = fitOf(joint, sample.pose);
    state.problem = misfit(joint, fit);
    if (!state.problem.empty()) return state;
    double difference = values.empty() ? 0 : fit.value - values.back();
    if (turns) difference = withoutTurns(difference);
    if (turns && std::abs(difference) >= kMaxTurn) {
      state.problem = "joint \"" + joint.name +
                      "\" turns by 90 degrees or more between two transforms, so its direction is "
                      "not known; send them more often";
      return state;
    }
    values.push_back(values.empty() ? fit.value : values.back() + difference);
    if (sample.stamp <= stamp || values.size() == 1) state.value = values.back();
  }
  if (samples.is_static) return state;
  const std::vector<std::size_t> cuts = piecesOf(samples.poses, window);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const std::int64_t time = samples.poses[cuts[i]].stamp - samples.poses[cuts[i - 1]].stamp;
    widen(state.speed, i == 1, values[cuts[i]] - values[cuts[i - 1]], time);
    state.piece = std::max(state.piece, static_cast<double>(time) / kSecond);
  }
  return state;
}

SpeedRange speedAtStamp(const JointState& state, std::optional<double> acceleration) {
  if (!acceleration || state.piece == 0) return state.speed;
  const double gain = *acceleration * (state.piece + kStampRounding);
  return {-fastest(-state.speed.lower, gain), fastest(state.speed.upper, gain)};
}

Limits stopOffsetsWithin(const JointRule& rule, const JointState& state, const SpeedRange& speed,
                         const Reaction& reaction) {
  Limits offsets = stopOffsets(speed, *rule.braking, reaction);
  if (!rule.limits) return offsets;
  const auto [lower, upper] = *rule.limits;
  const double turn = rule.joint->motion == Motion::kRotation ? 2 * M_PI : 0;
  const double first =
      turn > 0 ? state.value + turn * std::ceil((lower - kMaxMisfit - state.value) / turn)
               : state.value;
  const bool obeys = first >= lower - kMaxMisfit && first <= upper + kMaxMisfit;
  const bool is_ambiguous = turn > 0 && first + turn <= upper + kMaxMisfit;
  if (!obeys || is_ambiguous) return offsets;
  offsets.upper = std::min(offsets.upper, std::max(0.0, upper - first) + kLimitRounding);
  offsets.lower = std::max(offsets.lower, std::min(0.0, lower - first) - kLimitRounding);
  return offsets;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Between two successive samples a joint must turn by less than 90 degrees. So its values can be
// continued beyond full turns.
#include "world/stopping/joint_speed.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace link_bounds {
namespace {

constexpr double kMaxMisfit = 1e-3;       // m and rad
constexpr double kMaxTurn = M_PI / 2;     // rad, between two transforms
constexpr double kValueRounding = 1e-12;  // rad or m, of the difference of two values
constexpr double kLimitRounding = 1e-9;   // rad or m

/// Max difference of the values in tf and in a report, beyond the motion between their stamps.
constexpr double kMaxReportError = 1e-3;  // rad or m

/// Max relative difference of the motions by positions and by velocities that noise alone explains.
constexpr double kMaxWayError = 0.005;
constexpr double kPositionNoise = 1e-4;  // rad or m, of encoders

constexpr double kSpeedRounding = 1e-12;  // relative

/// Extends the range by the mean speed between two values, plus and minus its rounding error.
void widen(SpeedRange& speed, bool is_first, double difference, std::int64_t nanoseconds) {
  const double time = static_cast<double>(nanoseconds) / kSecond;
  const double longest = std::abs(difference) + kValueRounding;
  const double shortest = time > 2 * kStampRounding ? time - kStampRounding : time / 2;
  const double error = longest / shortest - std::abs(difference) / time;
  const double mean = difference / time;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!std::isfinite(mean) || !std::isfinite(error)) {
    speed = {-kInfinite, kInfinite};
    return;
  }
  speed.lower = is_first ? mean - error : std::min(speed.lower, mean - error);
  speed.upper = is_first ? mean + error : std::max(speed.upper, mean + error);
}

double fastest(double mean, double gain) {
  return std::max(mean + gain / 2, gain);
}

/// Joint values and their stamps [ns]. The values of a turning joint do not jump by full turns.
struct TimedValues {
  std::vector<std::int64_t> stamps;
  std::vector<double> values;
};

void addSpeeds(const TimedValues& samples, std::int64_t window, JointState& state) {
  const std::vector<std::size_t> cuts = piecesOf(samples.stamps, window);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const std::int64_t time = samples.stamps[cuts[i]] - samples.stamps[cuts[i - 1]];
    widen(state.speed, i == 1, samples.values[cuts[i]] - samples.values[cuts[i - 1]], time);
    state.piece = std::max(state.piece, static_cast<double>(time) / kSecond);
  }
}

bool haveVelocities(const std::vector<JointReport>& reports) {
  return std::all_of(reports.begin(), reports.end(),
                     [](const JointReport& report) { return report.velocity; });
}

/// Whether all velocities are 0, which may mean that they are not measured. None may be missing.
bool areZeros(const std::vector<JointReport>& reports) {
  return std::all_of(reports.begin(), reports.end(),
                     [](const JointReport& report) { return *report.velocity == 0; });
}

bool restedSince(const std::optional<JointReport>& before,
                 const std::vector<JointReport>& reports) {
  return before && std::all_of(reports.begin(), reports.end(), [&](const JointReport& report) {
           return std::abs(report.position - before->position) <= kPositionNoise;
         });
}

/// The motion from one report to the next by their velocities [rad or m].
double wayOf(const JointReport& from, const JointReport& to) {
  return (*from.velocity + *to.velocity) / 2 * static_cast<double>(to.stamp - from.stamp) / kSecond;
}

/// Whether the motions by velocities and by positions differ in any piece of the window. A driver
/// may filter the velocities, which makes them late, or send zeros now and then.
bool contradict(const std::vector<JointReport>& reports, const TimedValues& positions,
                std::int64_t window) {
  const std::vector<std::size_t> cuts = piecesOf(positions.stamps, window);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double way = positions.values[cuts[i]] - positions.values[cuts[i - 1]];
    double told = 0;
    for (std::size_t k = cuts[i - 1] + 1; k <= cuts[i]; ++k)
      told += wayOf(reports[k - 1], reports[k]);
    if (std::abs(way - told) > kPositionNoise + kMaxWayError * std::abs(way)) return true;
  }
  return false;
}

/// Max difference of the motions by positions and by velocities, from any report of the last piece
/// to the last report [rad or m].
double differenceAtEnd(const std::vector<JointReport>& reports, const TimedValues& positions,
                       std::int64_t window) {
  const std::size_t last = reports.size() - 1;
  double told = 0, largest = 0;
  for (std::size_t k = last; k > 0; --k) {
    told += wayOf(reports[k - 1], reports[k]);
    const double way = positions.values[last] - positions.values[k - 1];
    largest = std::max(largest, std::abs(way - told));
    if (reports[last].stamp - reports[k - 1].stamp >= window / kMinPieces) break;
  }
  return largest;
}

/// All reports must have a velocity. It may change between the nearest report and the stamp. A
/// driver may send zeros instead of measured velocities, so speeds by positions count, too. If the
/// positions contradict the velocities, the joint may also have accelerated during a whole piece.
void addReportedSpeeds(const std::vector<JointReport>& reports, std::int64_t stamp,
                       const TimedValues& positions, std::int64_t window, JointState& state) {
  JointState of_positions;
  addSpeeds(positions, window, of_positions);
  state.speed = {*reports.front().velocity, *reports.front().velocity};
  std::int64_t gap = std::abs(stamp - reports.front().stamp);
  for (const JointReport& report : reports) {
    state.speed.lower = std::min(state.speed.lower, *report.velocity);
    state.speed.upper = std::max(state.speed.upper, *report.velocity);
    gap = std::min(gap, std::abs(stamp - report.stamp));
  }
  state.piece = 2 * static_cast<double>(gap) / kSecond;
  const auto [lowest, highest] =
      std::minmax_element(positions.values.begin(), positions.values.end());
  const bool is_still = *highest - *lowest <= kPositionNoise;
  const bool are_zeros = areZeros(reports);
  if (is_still && *reports.back().velocity == 0) state.unseen = kPositionNoise;
  if (of_positions.piece == 0) return;
  if ((are_zeros && !is_still) || contradict(reports, positions, window)) {
    state.piece += of_positions.piece;
  } else if (!are_zeros) {
    // Let the last velocity be wrong by e. This error changes by at most 2 a per second, with a the
    // acceleration. So the motions by velocities and by positions differ by at least e^2 / (4 a).
    state.unseen = std::max(state.unseen, 2 * differenceAtEnd(reports, positions, window));
  }
  state.speed.lower = std::min(state.speed.lower, of_positions.speed.lower);
  state.speed.upper = std::max(state.speed.upper, of_positions.speed.upper);
}

/// Removes a last report after the stamp that comes more than `window` after the previous report.
std::vector<JointReport> withoutLate(std::vector<JointReport> reports, std::int64_t stamp,
                                     std::int64_t window) {
  const std::size_t count = reports.size();
  const bool is_late = count > 1 && reports.back().stamp > stamp &&
                       reports.back().stamp - reports[count - 2].stamp > window;
  if (is_late) reports.pop_back();
  return reports;
}

/// Whether the reports are close enough in time to compute speeds from their positions.
bool tellSpeed(const std::vector<JointReport>& reports, std::int64_t window) {
  const auto is_gap = [window](const JointReport& a, const JointReport& b) {
    return b.stamp - a.stamp > window;
  };
  return reports.size() > 1 &&
         std::adjacent_find(reports.begin(), reports.end(), is_gap) == reports.end();
}

std::string whyTooRare(const Joint& joint) {
  return "joint_states has joint \"" + joint.name +
         "\" too rarely for ~velocity_window, or at other times than tf; raise "
         "~velocity_window, or send it more often";
}

std::string whyNoDirection(const Joint& joint, const std::string& samples) {
  return "joint \"" + joint.name + "\" turns by 90 degrees or more between two " + samples +
         ", so its direction is not known; send them more often";
}

/// Max difference of the joint value at `stamp` from the one in the report [rad or m].
double reportError(const JointReport& report, const JointState& state, std::int64_t stamp) {
  const double fastest = std::max(std::abs(state.speed.lower), std::abs(state.speed.upper));
  return kMaxReportError + fastest * static_cast<double>(std::abs(stamp - report.stamp)) / kSecond;
}

/// Null if there is none.
const JointReport* nearestReport(const std::vector<JointReport>& reports, std::int64_t stamp) {
  const JointReport* nearest = nullptr;
  for (const JointReport& report : reports) {
    if (!nearest || std::abs(stamp - report.stamp) < std::abs(stamp - nearest->stamp))
      nearest = &report;
  }
  return nearest;
}

TimedValues positionsOf(const std::vector<JointReport>& reports) {
  TimedValues found;
  for (const JointReport& report : reports) {
    found.stamps.push_back(report.stamp);
    found.values.push_back(report.position);
  }
  return found;
}

/// Some drivers keep the positions of continuous joints within one turn. Restores full turns by the
/// velocities. False if a step of 90 degrees or more contradicts these, which may be zeros that
/// were not measured: then the direction of the step is not known.
bool addTurns(const std::vector<JointReport>& reports, std::vector<double>& positions) {
  for (std::size_t i = 1; i < reports.size(); ++i) {
    const double told = wayOf(reports[i - 1], reports[i]);
    const double difference = reports[i].position - reports[i - 1].position;
    const double more = withoutTurns(difference - told);
    if (std::abs(difference) >= kMaxTurn && std::abs(more) >= kMaxTurn) return false;
    positions[i] = positions[i - 1] + told + more;
  }
  return true;
}

/// A single velocity may be late or wrong. With the report before it, positions give a speed, too.
std::vector<JointReport> withBefore(std::vector<JointReport> reports,
                                    const std::optional<JointReport>& before) {
  if (reports.size() == 1 && before && before->velocity) reports.insert(reports.begin(), *before);
  return reports;
}

/// All reports must have a velocity.
void addSpeedsOfVelocities(const Joint& joint, const std::vector<JointReport>& reports,
                           std::int64_t stamp, std::int64_t window, JointState& state) {
  TimedValues found = positionsOf(reports);
  if (joint.motion == Motion::kRotation && !joint.limits && !addTurns(reports, found.values)) {
    state.problem = whyNoDirection(joint, "reports in joint_states");
    return;
  }
  addReportedSpeeds(reports, stamp, found, window, state);
}

void addSpeedsOfPositions(const std::vector<JointReport>& reports, std::int64_t stamp,
                          std::int64_t window, JointState& state) {
  addSpeeds(positionsOf(reports), window, state);
  // The joint may have accelerated since the last report. For speedAtStamp(), this gap counts as
  // much as twice its length in a piece.
  const std::int64_t gap = std::max<std::int64_t>(stamp - reports.back().stamp, 0);
  state.piece += 2 * static_cast<double>(gap) / kSecond;
}

}  // namespace

std::string whyMisfit(const Joint& joint, const JointFit& fit) {
  if (fit.length_error <= kMaxMisfit && fit.angle_error <= kMaxMisfit) return "";
  return "a transform does not fit joint \"" + joint.name + "\": it is off by " +
         std::to_string(fit.length_error * 1e3) + " mm and " +
         std::to_string(fit.angle_error * 1e3) +
         " mrad; correct its publisher or the robot description";
}

std::string unwrap(const Joint& joint, std::vector<JointReport>& reports) {
  if (joint.motion != Motion::kRotation || joint.limits || haveVelocities(reports)) return "";
  for (std::size_t i = 1; i < reports.size(); ++i) {
    const double difference = withoutTurns(reports[i].position - reports[i - 1].position);
    if (std::abs(difference) >= kMaxTurn) return whyNoDirection(joint, "reports in joint_states");
    reports[i].position = reports[i - 1].position + difference;
  }
  return "";
}

JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose, const EdgeSamples& samples,
                      std::int64_t window) {
  JointState state;
  const JointFit at_stamp = fitOf(joint, pose);
  state.problem = whyMisfit(joint, at_stamp);
  if (!state.problem.empty()) return state;
  state.value = at_stamp.value;
  const bool turns = joint.motion == Motion::kRotation;
  TimedValues found;
  for (const TimedPose& sample : samples.poses) {
    const JointFit fit = fitOf(joint, sample.pose);
    state.problem = whyMisfit(joint, fit);
    if (!state.problem.empty()) return state;
    std::vector<double>& values = found.values;
    double difference = values.empty() ? 0 : fit.value - values.back();
    if (turns) difference = withoutTurns(difference);
    if (turns && std::abs(difference) >= kMaxTurn) {
      state.problem = whyNoDirection(joint, "transforms");
      return state;
    }
    found.stamps.push_back(sample.stamp);
    values.push_back(values.empty() ? fit.value : values.back() + difference);
  }
  if (!samples.is_static) addSpeeds(found, window, state);
  return state;
}

JointState jointState(const Joint& joint, const Eigen::Isometry3d& pose,
                      const std::vector<JointReport>& all_reports, std::int64_t stamp,
                      std::int64_t window, const std::optional<JointReport>& before) {
  JointState state;
  const JointFit fit = fitOf(joint, pose);
  state.problem = whyMisfit(joint, fit);
  if (!state.problem.empty()) return state;
  const bool have_velocities = haveVelocities(all_reports);
  const std::vector<JointReport> reports =
      have_velocities ? all_reports : withoutLate(all_reports, stamp, window);
  const bool is_any_late = reports.size() < all_reports.size();
  const JointReport* const nearest = nearestReport(reports, stamp);
  const bool are_told = have_velocities && (!areZeros(reports) || restedSince(before, reports));
  if (!nearest || std::abs(stamp - nearest->stamp) > window ||
      (!are_told && !tellSpeed(withoutLate(all_reports, stamp, window), window))) {
    state.problem = whyTooRare(joint);
    return state;
  }
  if (have_velocities) {
    addSpeedsOfVelocities(joint, withBefore(reports, before), stamp, window, state);
    if (!state.problem.empty()) return state;
  } else {
    addSpeedsOfPositions(reports, stamp, window, state);
    if (is_any_late) {
      const JointReport& late = all_reports.back();
      const JointReport& last = reports.back();
      widen(state.speed, false, late.position - last.position, late.stamp - last.stamp);
    }
  }
  double error = fit.value - nearest->position;
  if (joint.motion == Motion::kRotation) error = withoutTurns(error);
  if (!(std::abs(error) <= reportError(*nearest, state, stamp))) {
    // Between two reports that are far apart, the joint may have moved in any way.
    state.problem = is_any_late ? whyTooRare(joint)
                                : "tf and joint_states differ by " +
                                      std::to_string(std::abs(error)) + " rad or m about joint \"" +
                                      joint.name + "\"; correct their publishers";
  }
  state.value = nearest->position + error;
  state.are_turns_known = true;
  return state;
}

SpeedRange speedAtStamp(const JointState& state, std::optional<double> acceleration) {
  if (!acceleration) return state.speed;
  const double from_rest = std::sqrt(2 * *acceleration * state.unseen) * (1 + kSpeedRounding);
  if (state.piece == 0) return {state.speed.lower - from_rest, state.speed.upper + from_rest};
  const double gain = *acceleration * (state.piece + kStampRounding);
  return {-fastest(-state.speed.lower, gain) - from_rest,
          fastest(state.speed.upper, gain) + from_rest};
}

Limits withinLimits(Limits offsets, const JointRule& rule, const JointState& state) {
  if (!rule.limits) return offsets;
  const auto [lower, upper] = *rule.limits;
  const bool may_be_turned = rule.joint->motion == Motion::kRotation && !state.are_turns_known;
  const double turn = may_be_turned ? 2 * M_PI : 0;
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

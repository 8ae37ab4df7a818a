// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What ~stopping and ~earliest cost per update, with all joints moving and tf at 100 Hz: on the
// robots of LINK_BOUNDS_DATA, else on that of the demo. Distances are those of convex hulls.
#include <algorithm>
#include <chrono>

#include "bench/common/benchmarks.h"
#include "bench/common/robots.h"
#include "bench/common/table.h"
#include "bench/common/target.h"
#include "bench/common/timing.h"
#include "testing/import_alone.h"
#include "testing/moving_robot.h"

namespace link_bounds::bench {
namespace {

constexpr double kTurnSpeed = 0.5;   // rad/s
constexpr double kSlideSpeed = 0.1;  // m/s
constexpr double kDeceleration = 2;  // rad/s^2 and m/s^2
constexpr double kBase = 1;          // m/s and rad/s

constexpr int kRounds = 5;

/// A limit of ~stopping, and of ~earliest [us].
struct Limit {
  const char* robot;
  double us;
};
constexpr Limit kLimits[] = {{"panda", 100}, {"gen3_robotiq_2f_85", 100}, {"pr2", 1000}};

/// Times of an update [us], the median of each round.
struct Times {
  std::string robot;
  std::size_t joints;
  std::size_t links;              ///< with a box
  std::vector<double> copying{};  ///< what the update thread gives
  std::vector<double> stopping{};
  std::vector<double> earliest{};
};

Times measureRobot(const RobotFile& file, int repetitions) {
  const std::string urdf = textOf(file.urdf);
  const Robot description = parseRobot(urdf);
  Parameters parameters;
  parameters.base_deceleration = {{"linear", kBase}, {"angular", kBase}};
  MovingRobot::Values values;
  MovingRobot::Values speeds;
  std::size_t moving = 0;
  for (const Joint& joint : description.joints) {
    parameters.deceleration[joint.name] = kDeceleration;
    const bool moves = hasValue(joint.motion) && !joint.axis.isZero(0);
    const Limits limits = joint.limits.value_or(Limits{-1, 1});
    values.push_back(moves ? (limits.lower + limits.upper) / 2 : 0);
    const double speed = joint.motion == Motion::kTranslation ? kSlideSpeed : kTurnSpeed;
    speeds.push_back(moves ? speed : 0);
    moving += moves;
  }
  MeshSource source;
  source.package_path = file.package_path;
  MovingRobot robot(urdf, parameters, importAlone, source);
  robot.move(values, speeds);
  const StopRules rules(robot.model());
  ContactTimes contacts({[](const auto&, const auto&) {}, [](const auto&) {}});
  const auto time = std::chrono::steady_clock::now();
  const auto scene = robot.copy();
  Times result{file.name(), moving, robot.model()->links.size()};
  const auto measure = [repetitions](std::vector<double>& times, const auto& function) {
    times.push_back(medianTime<std::micro>(repetitions, function));
  };
  for (int round = 0; round < kRounds; ++round) {
    measure(result.copying, [&] { robot.copy(); });
    measure(result.stopping, [&] { stoppingBoxes(*scene, rules); });
    measure(result.earliest,
            [&] { contacts.compute(*scene, rules, nullptr, time, [] { return false; }); });
  }
  return result;
}

Row rowOf(const Times& times) {
  return {{"robot", times.robot},
          {"joints", times.joints},
          {"links", times.links},
          {"copying_us", median(times.copying)},
          {"stopping_us", median(times.stopping)},
          {"earliest_us", median(times.earliest)}};
}

/// Of one robot; without values if it was not measured.
std::vector<Target> targetsOf(const Limit& limit, const std::vector<Times>& all) {
  const auto found = std::find_if(
      all.begin(), all.end(), [&limit](const Times& times) { return times.robot == limit.robot; });
  const Times times = found == all.end() ? Times{limit.robot, 0, 0} : *found;
  return {{"~stopping of " + times.robot, Wanted::kAtMost, limit.us, times.stopping},
          {"~earliest of " + times.robot, Wanted::kAtMost, limit.us, times.earliest}};
}

}  // namespace

Rows benchmarkStopping(bool quick) {
  const Table table("us per update, median", {{"robot", "", 20},
                                              {"joints"},
                                              {"links"},
                                              {"copying_us", "copying, on the update thread"},
                                              {"stopping_us", "~stopping"},
                                              {"earliest_us", "~earliest"}});
  std::vector<Times> all;
  Rows rows;
  for (const RobotFile& file : robots()) {
    all.push_back(measureRobot(file, quick ? 10 : 100));
    table.add(rows.emplace_back(rowOf(all.back())));
  }
  std::vector<Target> targets;
  for (const Limit& limit : kLimits) {
    for (Target& target : targetsOf(limit, all))
      targets.push_back(std::move(target));
  }
  printTargets(", us per update", targets);
  return rows;
}

}  // namespace link_bounds::bench

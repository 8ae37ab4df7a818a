// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What ~stopping and ~earliest cost per update, with all joints moving and tf at 100 Hz: on the
// robots of LINK_BOUNDS_DATA, else on that of the demo. Distances are those of convex hulls.
#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>

#include "bench/common/benchmark_main.h"
#include "bench/common/target.h"
#include "bench/common/timing.h"
#include "testing/import_alone.h"
#include "testing/moving_robot.h"
#include "testing/robot_files.h"

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
struct Row {
  std::string robot;
  std::size_t joints;
  std::size_t links;              ///< with a box
  std::vector<double> copying{};  ///< what the update thread gives
  std::vector<double> stopping{};
  std::vector<double> earliest{};
};

Row measureRobot(const RobotFile& file, int repetitions) {
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
  Row row{file.name(), moving, robot.model()->links.size()};
  const auto measure = [repetitions](std::vector<double>& times, const auto& function) {
    times.push_back(medianTime<std::micro>(repetitions, function));
  };
  for (int round = 0; round < kRounds; ++round) {
    measure(row.copying, [&] { robot.copy(); });
    measure(row.stopping, [&] { stoppingBoxes(*scene, rules); });
    measure(row.earliest,
            [&] { contacts.compute(*scene, rules, nullptr, time, [] { return false; }); });
  }
  return row;
}

std::vector<Row> measureAll(int repetitions) {
  std::vector<Row> rows;
  for (const RobotFile& file : robotsOrDemo(LINK_BOUNDS_DEMO_URDF, std::cout))
    rows.push_back(measureRobot(file, repetitions));
  return rows;
}

void printTable(const std::vector<Row>& rows) {
  std::cout
      << "us per update, median\n\n| robot | joints | links | copying, on the update thread | "
         "~stopping | ~earliest |\n|---|---:|---:|---:|---:|---:|\n"
      << std::fixed << std::setprecision(0);
  for (const Row& row : rows) {
    std::cout << "| " << row.robot << " | " << row.joints << " | " << row.links << " | "
              << median(row.copying) << " | " << median(row.stopping) << " | "
              << median(row.earliest) << " |\n";
  }
}

void printTargets(const std::vector<Row>& rows) {
  std::cout << "\nTargets, us per update\n";
  for (const Limit& limit : kLimits) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&limit](const Row& each) { return each.robot == limit.robot; });
    const std::string robot = limit.robot;
    const bool is_there = row != rows.end();
    print({"~stopping of " + robot, Wanted::kAtMost, limit.us,
           is_there ? row->stopping : std::vector<double>()},
          "run", "runs", std::cout);
    print({"~earliest of " + robot, Wanted::kAtMost, limit.us,
           is_there ? row->earliest : std::vector<double>()},
          "run", "runs", std::cout);
  }
}

void write(const std::vector<Row>& rows, std::ostream& json) {
  json << "[";
  for (const Row& row : rows) {
    json << (&row == &rows.front() ? "" : ",") << "\n  {\"robot\": \"" << row.robot
         << "\", \"joints\": " << row.joints << ", \"links\": " << row.links
         << ", \"copying_us\": " << median(row.copying)
         << ", \"stopping_us\": " << median(row.stopping)
         << ", \"earliest_us\": " << median(row.earliest) << "}";
  }
  json << "\n]\n";
}

void measure(bool quick, std::ostream* json) {
  const std::vector<Row> rows = measureAll(quick ? 10 : 100);
  printTable(rows);
  printTargets(rows);
  if (json) write(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::measure);
}

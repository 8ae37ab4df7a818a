// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What ~stopping and ~earliest cost per update, with all joints moving and tf at 100 Hz: on the
// robots of LINK_BOUNDS_DATA, else on that of the demo. Distances are those of convex hulls.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "bench/common/benchmark_main.h"
#include "bench/common/result.h"
#include "robot/worker/mesh_import.h"
#include "testing/moving_robot.h"
#include "testing/robot_files.h"

namespace link_bounds::bench {
namespace {

constexpr double kTurnSpeed = 0.5;   // rad/s
constexpr double kSlideSpeed = 0.1;  // m/s
constexpr double kDeceleration = 2;  // rad/s^2 and m/s^2
constexpr double kBase = 1;          // m/s and rad/s

/// All times are medians [us].
struct Row {
  std::string robot;
  std::size_t joints;
  std::size_t links;  ///< with a box
  double copying;     ///< what the update thread gives
  double stopping;
  double earliest;
};

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TriangleMesh importAlone(const MeshFile& mesh) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return importMesh(mesh);
}

template <class Function>
double medianUs(int repetitions, Function function) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    function();
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
            .count());
  }
  return median(times);
}

Row measureRobot(const std::filesystem::path& file, const PackagePath& package_path,
                 int repetitions) {
  const std::string urdf = textOf(file);
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
  source.package_path = package_path;
  MovingRobot robot(urdf, parameters, importAlone, source);
  robot.move(values, speeds);
  const StopRules rules(robot.model());
  ContactTimes contacts({[](const auto&, const auto&) {}, [](const auto&) {}});
  const auto time = std::chrono::steady_clock::now();
  const auto scene = robot.copy();
  Row row{file.stem().string(), moving, robot.model()->links.size(), 0, 0, 0};
  row.copying = medianUs(repetitions, [&] { robot.copy(); });
  row.stopping = medianUs(repetitions, [&] { stoppingBoxes(*scene, rules); });
  row.earliest = medianUs(
      repetitions, [&] { contacts.compute(*scene, rules, nullptr, time, [] { return false; }); });
  return row;
}

std::vector<Row> measureAll(int repetitions) {
  const char* const data = std::getenv("LINK_BOUNDS_DATA");
  if (!data) {
    const std::filesystem::path demo = LINK_BOUNDS_DEMO_URDF;
    const std::string package = demo.parent_path().parent_path().parent_path().string();
    return {measureRobot(
        demo, [package](const std::string&) { return package; }, repetitions)};
  }
  const std::filesystem::path robots = std::filesystem::path(data) / "robots";
  const PackagePath package_path = [&](const std::string& package) {
    return (robots / package).string();
  };
  std::vector<Row> rows;
  for (const std::filesystem::path& file : robotFiles(robots))
    rows.push_back(measureRobot(file, package_path, repetitions));
  return rows;
}

void print(const std::vector<Row>& rows) {
  std::cout
      << "us per update, median\n\n| robot | joints | links | copying, on the update thread | "
         "~stopping | ~earliest |\n|---|---:|---:|---:|---:|---:|\n"
      << std::fixed << std::setprecision(0);
  for (const Row& row : rows) {
    std::cout << "| " << row.robot << " | " << row.joints << " | " << row.links << " | "
              << row.copying << " | " << row.stopping << " | " << row.earliest << " |\n";
  }
}

void write(const std::vector<Row>& rows, std::ostream& json) {
  json << "[";
  for (const Row& row : rows) {
    json << (&row == &rows.front() ? "" : ",") << "\n  {\"robot\": \"" << row.robot
         << "\", \"joints\": " << row.joints << ", \"links\": " << row.links
         << ", \"copying_us\": " << row.copying << ", \"stopping_us\": " << row.stopping
         << ", \"earliest_us\": " << row.earliest << "}";
  }
  json << "\n]\n";
}

void measure(bool quick, std::ostream* json) {
  const std::vector<Row> rows = measureAll(quick ? 20 : 200);
  print(rows);
  if (json) write(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::measure);
}

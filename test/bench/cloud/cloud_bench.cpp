// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times the points of robots in clouds, ours and others: cloud_bench [--quick] [--json FILE]
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>

#include "bench/cloud/cloud_methods.h"
#include "bench/common/benchmark_main.h"
#include "bench/common/machine.h"
#include "tools/cloud_filter/filtered_robot.h"
#include "world/cloud/nearest_points.h"
#include "world/cloud/without_points.h"

namespace link_bounds::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Of this thread, so that other programs count little [ms].
double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

struct Row {
  std::string scene, method;
  std::size_t points = 0, robot_points = 0;
  std::vector<double> ms;  ///< sorted

  double at(double share) const {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  }
};

/// `prepare` is not timed.
template <class Prepare, class Work>
Row measure(const CloudScene& scene, const std::string& method, std::size_t rounds,
            const Prepare& prepare, const Work& work) {
  Row row{scene.name, method, std::size_t{scene.cloud.width} * scene.cloud.height, 0, {}};
  for (std::size_t i = 0; i <= rounds; ++i) {
    prepare();
    const double begin = processorTime();
    row.robot_points = work();
    if (i > 0) row.ms.push_back(processorTime() - begin);
  }
  std::sort(row.ms.begin(), row.ms.end());
  return row;
}

/// From a received message to the one that is sent.
std::size_t filter(const CloudScene& scene, bool with_nearest, sensor_msgs::PointCloud2& cloud) {
  const ScannedRobot& robot = *scene.robot;
  const CloudLayout layout = layoutOf(cloud);
  const auto sensor = *robot.tf.find("sensor");
  const ScanPoses poses = scanPoses(robot.tf, sensor, robot.links, *timeSpan(layout.points));
  const auto removed = robotPoints({layout.points, robot.grids, poses});
  if (with_nearest)
    nearestPoints({layout.points, removed, robot.grids, robot.links, robot.tf, sensor});
  removePoints(removed, true, cloud);
  return removed.size();
}

/// The sum keeps the compiler from leaving it out.
std::size_t readAll(const CloudScene& scene) {
  const CloudPoints points = layoutOf(scene.cloud).points;
  double sum = 0;
  for (std::size_t row = 0; row < points.height; ++row) {
    const std::uint8_t* bytes = points.data + row * points.row_step;
    for (std::size_t i = 0; i < points.width; ++i, bytes += points.point_step)
      sum += points.position(bytes).sum();
  }
  volatile double kept = sum;
  static_cast<void>(kept);
  return 0;
}

void print(const Row& row) {
  std::cout << std::left << std::setw(28) << row.scene << std::setw(26) << row.method << std::right
            << std::fixed << std::setprecision(2) << std::setw(9) << row.at(0.5) << std::setw(9)
            << row.at(0.99) << std::setw(11) << std::setprecision(1)
            << static_cast<double>(row.points) / row.at(0.5) / 1e3 << std::setw(9)
            << 100 * static_cast<double>(row.robot_points) / static_cast<double>(row.points) << "\n"
            << std::flush;
}

std::vector<Row> measureScene(const CloudScene& scene, bool quick) {
  std::vector<Row> rows;
  const auto add = [&](Row row) {
    print(row);
    rows.push_back(std::move(row));
  };
  const std::size_t rounds = quick ? 30 : 300;
  sensor_msgs::PointCloud2 cloud;
  const auto copy = [&] { cloud = scene.cloud; };
  const auto nothing = [] {};
  add(measure(scene, "link_bounds", rounds, copy, [&] { return filter(scene, false, cloud); }));
  add(measure(scene, "link_bounds with ~nearest", rounds, copy,
              [&] { return filter(scene, true, cloud); }));
  add(measure(scene, "plain read", rounds, nothing, [&] { return readAll(scene); }));
#ifdef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
  const LabelAll peer = geometricShapes(scene);
  add(measure(scene, "geometric_shapes", quick ? 2 : 10, nothing, peer));
#endif
#ifdef LINK_BOUNDS_WITH_PCL
  const LabelAll crop = cropHull(scene);
  add(measure(scene, "PCL's CropHull", quick ? 1 : 3, nothing, crop));
#endif
  return rows;
}

void measureLoading(const RobotFile& file) {
  const std::string urdf = textOf(file.urdf);
  const auto begin = Clock::now();
  const FilteredRobot robot = *filteredRobot(urdf, {}, [] { return false; });
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::size_t bytes = 0, largest = 0;
  std::vector<std::shared_ptr<const BodyGrid>> grids = robot.grids;
  std::sort(grids.begin(), grids.end());
  grids.erase(std::unique(grids.begin(), grids.end()), grids.end());
  for (const auto& grid : grids) {
    bytes += grid->bytes();
    largest = std::max(largest, grid->bytes());
  }
  std::cout << "from the description of " << file.name() << " to " << grids.size() << " grids of "
            << robot.links.size() << " links: " << std::fixed << std::setprecision(2) << seconds
            << " s, " << bytes / 1000 << " kB, the largest " << largest / 1000 << " kB\n"
            << std::flush;
}

void writeJson(const std::vector<Row>& rows, std::ostream& out) {
  const char* separator = "[\n";
  for (const Row& row : rows) {
    out << separator << "{\"scene\": " << std::quoted(row.scene)
        << ", \"method\": " << std::quoted(row.method) << ", \"points\": " << row.points
        << ", \"robot_points\": " << row.robot_points << ", \"p50_ms\": " << row.at(0.5)
        << ", \"p99_ms\": " << row.at(0.99) << "}";
    separator = ",\n";
  }
  out << "\n]\n";
}

const Row* find(const std::vector<Row>& rows, const std::string& scene, const std::string& method) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.scene == scene && row.method == method;
  });
  return found == rows.end() ? nullptr : &*found;
}

void printRatios(const std::vector<Row>& rows) {
  std::cout << "\n";
  for (const Row& row : rows) {
    if (row.method != "link_bounds") continue;
    const Row* read = find(rows, row.scene, "plain read");
    std::cout << row.scene << ": " << std::setprecision(1) << row.at(0.5) / read->at(0.5)
              << " times the plain read";
    for (const char* method : {"geometric_shapes", "PCL's CropHull"}) {
      if (const Row* peer = find(rows, row.scene, method))
        std::cout << ", " << peer->at(0.5) / row.at(0.5) << " times as fast as " << method;
    }
    std::cout << "\n";
  }
}

void benchmarkClouds(bool quick, std::ostream* json) {
  std::cout << "compiler: " << LINK_BOUNDS_COMPILER << "\nCPU: " << cpuName()
            << ", one thread, its processor time\npeers: " << LINK_BOUNDS_PEERS
            << "\npadding: " << kPadding * 1e3 << " mm\n\n";
#ifndef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
  std::cout << "left out, because this system lacks it: geometric_shapes\n";
#endif
#ifndef LINK_BOUNDS_WITH_PCL
  std::cout << "left out, because this system lacks it, or geometric_shapes: PCL's CropHull\n";
#endif
  const auto folder = robotsFolder();
  RobotFile panda = demoRobotFile(LINK_BOUNDS_DEMO_URDF), pr2 = panda;
  std::string ros_packages = panda.package_path("");
  if (folder) {
    panda = robotFile(*folder, "franka_description/urdf/panda.urdf");
    pr2 = robotFile(*folder, "pr2_description/urdf/pr2.urdf");
    ros_packages = folder->string();
  } else {
    std::cout << "LINK_BOUNDS_DATA is not set: the demo's robot stands in for public ones\n";
  }
  setenv("ROS_PACKAGE_PATH", ros_packages.c_str(), 1);
  measureLoading(panda);
  measureLoading(pr2);
  std::cout << "\n"
            << std::left << std::setw(28) << "scene" << std::setw(26) << "method" << std::right
            << std::setw(9) << "p50 ms" << std::setw(9) << "p99 ms" << std::setw(11) << "Mpoints/s"
            << std::setw(9) << "robot %"
            << "\n";
  std::vector<Row> rows;
  for (const auto& [make, file] : {std::pair(depthCamera, panda), std::pair(lidar, pr2)}) {
    const std::vector<Row> more = measureScene(make(file), quick);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  printRatios(rows);
  if (json) writeJson(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkClouds);
}

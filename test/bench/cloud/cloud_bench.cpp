// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times the points of robots in clouds, ours and others.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "bench/cloud/cloud_methods.h"
#include "bench/common/benchmarks.h"
#include "bench/common/robots.h"
#include "bench/common/table.h"
#include "bench/common/timing.h"
#include "tools/cloud_filter/filtered_robot.h"
#include "world/cloud/nearest_points.h"
#include "world/cloud/without_points.h"

namespace link_bounds::bench {
namespace {

/// Of one method on one scene.
struct Times {
  std::string method;
  std::size_t robot_points = 0;
  std::vector<double> ms{};
};

/// `prepare` is not timed.
template <class Prepare, class Work>
Times measure(const std::string& method, std::size_t rounds, const Prepare& prepare,
              const Work& work) {
  Times times{method};
  for (std::size_t i = 0; i <= rounds; ++i) {
    prepare();
    const double begin = threadSeconds();
    times.robot_points = work();
    if (i > 0) times.ms.push_back((threadSeconds() - begin) * 1e3);
  }
  return times;
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

std::vector<Times> measureScene(const CloudScene& scene, bool quick) {
  std::vector<Times> all;
  const std::size_t rounds = quick ? 30 : 300;
  sensor_msgs::PointCloud2 cloud;
  const auto copy = [&] { cloud = scene.cloud; };
  const auto nothing = [] {};
  all.push_back(measure("link_bounds", rounds, copy, [&] { return filter(scene, false, cloud); }));
  all.push_back(measure("link_bounds with ~nearest", rounds, copy,
                        [&] { return filter(scene, true, cloud); }));
  all.push_back(measure("plain read", rounds, nothing, [&] { return readAll(scene); }));
#ifdef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
  all.push_back(measure("geometric_shapes", quick ? 2 : 10, nothing, geometricShapes(scene)));
#endif
#ifdef LINK_BOUNDS_WITH_PCL
  all.push_back(measure("PCL's CropHull", quick ? 1 : 3, nothing, cropHull(scene)));
#endif
  return all;
}

Row rowOf(const CloudScene& scene, const Times& times) {
  const std::size_t points = std::size_t{scene.cloud.width} * scene.cloud.height;
  const double count = static_cast<double>(points);
  return {{"scene", scene.name},
          {"method", times.method},
          {"points", points},
          {"robot_points", times.robot_points},
          {"p50_ms", quantile(times.ms, 0.5)},
          {"p99_ms", quantile(times.ms, 0.99)},
          {"mpoints_per_s", count / quantile(times.ms, 0.5) / 1e3},
          {"robot_percent", 100 * static_cast<double>(times.robot_points) / count}};
}

Rows printScene(const CloudScene& scene, const std::vector<Times>& all) {
  const Table table(scene.name, {{"method", "", 26},
                                 {"p50_ms", "p50 ms"},
                                 {"p99_ms", "p99 ms"},
                                 {"mpoints_per_s", "Mpoints/s"},
                                 {"robot_percent", "robot %"}});
  Rows rows;
  for (const Times& times : all)
    table.add(rows.emplace_back(rowOf(scene, times)));
  return rows;
}

void measureLoading(const RobotFile& file) {
  const std::string urdf = textOf(file.urdf);
  FilteredRobot robot;
  const double seconds = elapsed<std::ratio<1>>(
      [&] { robot = std::move(*filteredRobot(urdf, {}, [] { return false; })); });
  std::size_t bytes = 0, largest = 0;
  std::vector<std::shared_ptr<const BodyGrid>> grids = robot.grids;
  std::sort(grids.begin(), grids.end());
  grids.erase(std::unique(grids.begin(), grids.end()), grids.end());
  for (const auto& grid : grids) {
    bytes += grid->bytes();
    largest = std::max(largest, grid->bytes());
  }
  std::cout << "from the description of " << file.name() << " to " << grids.size() << " grids of "
            << robot.links.size() << " links: " << Value(seconds).text() << " s, " << bytes / 1000
            << " kB, the largest " << largest / 1000 << " kB\n"
            << std::flush;
}

void printRatios(const Rows& rows) {
  const auto ms = [&rows](const char* method) {
    return median(numbersOf(rows, {{"method", method}}, "p50_ms"));
  };
  std::cout << "\nlink_bounds takes " << Value(ms("link_bounds") / ms("plain read")).text()
            << " times the plain read";
  for (const char* method : {"geometric_shapes", "PCL's CropHull"}) {
    const double ratio = ms(method) / ms("link_bounds");
    if (!std::isnan(ratio))
      std::cout << ", is " << Value(ratio).text() << " times as fast as " << method;
  }
  std::cout << "\n" << std::flush;
}

}  // namespace

Rows benchmarkClouds(bool quick) {
  std::cout << "one thread, its processor time; padding: " << kPadding * 1e3 << " mm\n\n";
  const auto folder = robotsFolder();
  RobotFile panda = demoRobot(), pr2 = panda;
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
  Rows rows;
  for (const auto& [make, file] : {std::pair(depthCamera, panda), std::pair(lidar, pr2)}) {
    const CloudScene scene = make(file);
    const Rows more = printScene(scene, measureScene(scene, quick));
    printRatios(more);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/cloud/cloud_scenes.h"

#include <cmath>

namespace link_bounds::bench {
namespace {

constexpr double kStamp = 1000;  // s
constexpr std::uint32_t kColumns = 2032, kLines = 128;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::unique_ptr<ScannedRobot> robotIn(const RobotFile& file,
                                      const Eigen::Isometry3d& root_from_sensor, double speed) {
  auto robot = std::make_unique<ScannedRobot>(file, kPadding);
  robot->makeGrids();
  brute_force::Random random(1);
  robot->move(random, speed, kStamp - 0.05, kStamp + 0.15, root_from_sensor);
  const auto at = [](double x, double y, double z) {
    return Eigen::Affine3d(Eigen::Translation3d(x, y, z));
  };
  robot->addScene(boxBody({20, 20, 0.1}, at(0, 0, -0.06)));     // the floor
  robot->addScene(boxBody({0.1, 20, 6}, at(-2.5, 0, 3)));       // a wall
  robot->addScene(boxBody({0.8, 1.2, 0.04}, at(0.9, 0, 0.1)));  // a table
  robot->addScene(boxBody({0.1, 0.1, 0.2}, at(0.7, 0.2, 0.22)));
  return robot;
}

CloudPoint measured(const ScannedRobot::Ray& ray, const Eigen::Vector3d& direction,
                    std::uint32_t time) {
  const auto hit = ray.cast(direction);
  if (!hit) return {kNan, kNan, kNan, time};
  const Eigen::Vector3f place = (hit->range * direction).cast<float>();
  return {place.x(), place.y(), place.z(), time};
}

}  // namespace

CloudScene depthCamera(const RobotFile& file) {
  constexpr std::uint32_t kWidth = 640, kHeight = 480;
  constexpr double kFocalLength = 525;  // pixels, as that of a Kinect
  CloudScene scene{file.name() + ", 640 x 480", nullptr, {}};
  scene.robot = robotIn(file, lookingAt({1.5, 0.6, 0.9}, {0.2, 0, 0.4}), 1);
  const ScannedRobot::Ray ray(*scene.robot, static_cast<std::int64_t>(kStamp * 1e9));
  std::vector<CloudPoint> points;
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d direction((u - kWidth / 2.0) / kFocalLength,
                                      (v - kHeight / 2.0) / kFocalLength, 1);
      points.push_back(measured(ray, direction, 0));
    }
  }
  scene.cloud = cloudOfPoints(points, kWidth, kStamp, false);
  return scene;
}

CloudScene lidar(const RobotFile& file) {
  CloudScene scene{file.name() + ", lidar of 128 lines", nullptr, {}};
  Eigen::Isometry3d root_from_sensor(Eigen::Translation3d(2.5, 0, 1.2));
  scene.robot = robotIn(file, root_from_sensor, 1);
  std::vector<CloudPoint> points(std::size_t{kColumns} * kLines);
  for (std::uint32_t column = 0; column < kColumns; ++column) {
    const std::uint32_t time = column * (100'000'000u / kColumns);
    const ScannedRobot::Ray ray(*scene.robot, static_cast<std::int64_t>(kStamp * 1e9) + time);
    const double turn = 2 * M_PI * column / kColumns;
    for (std::uint32_t line = 0; line < kLines; ++line) {
      const double rise = (line / (kLines - 1.0) - 0.5) * M_PI / 4;
      const Eigen::Vector3d direction(std::cos(rise) * std::cos(turn),
                                      std::cos(rise) * std::sin(turn), std::sin(rise));
      points[std::size_t{line} * kColumns + column] = measured(ray, direction, time);
    }
  }
  scene.cloud = cloudOfPoints(points, kColumns, kStamp);
  return scene;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How tight parts are, by the max number per link.
#include <iostream>
#include <mutex>
#include <set>

#include "bench/common/benchmarks.h"
#include "bench/common/robots.h"
#include "bench/common/table.h"
#include "bench/common/timing.h"
#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/worker/mesh_import.h"
#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr int kLevels[] = {1, 2, 4, 8, 16, 64};
constexpr int kTurns = 100;
constexpr int kFewTurns = 10;

struct Model {
  std::string name;
  RobotFile file;
};

struct Parts {
  int level = 0;
  std::size_t parts = 0;
  double volume = 0;         ///< sum over all parts, joints at 0 [m^3]
  double turned_volume = 0;  ///< mean over random orientations of the complete robot [m^3]
  std::size_t bytes = 0;     ///< of the points of parts
  double seconds = 0;        ///< without reading the files
};

/// A robot with all joints at 0, read once.
class RestingRobot {
 public:
  explicit RestingRobot(const RobotFile& file)
      : robot_(parseRobot(textOf(file.urdf))), package_path_(file.package_path) {
    const auto poses = linkPoses(robot_, jointValues(robot_, {}));
    for (std::size_t i = 0; i < poses.size(); ++i)
      poses_.emplace(robot_.links[i].name, poses[i]);
    whole_ = bounded(1);
    for (const std::string& problem : whole_.problems)
      std::cerr << problem << "\n";
  }

  Parts measure(int level, int turns) {
    Parts result;
    result.level = level;
    BoundedRobot robot;
    result.seconds = elapsed<std::ratio<1>>([&] { robot = bounded(level); });
    std::vector<BoundedLink> parts;
    for (const auto& of_link : robot.parts)
      parts.insert(parts.end(), of_link.begin(), of_link.end());
    if (level == 1) parts = robot.links;
    result.parts = parts.size();
    result.bytes = bytesOf(parts);
    result.volume = volumeOf(parts, Eigen::Affine3d::Identity());
    brute_force::Random random(1);
    for (int i = 0; i < turns; ++i)
      result.turned_volume += volumeOf(parts, random.rigid(0)) / turns;
    return result;
  }

 private:
  BoundedRobot bounded(int level) {
    Selection selection;
    selection.parts_per_link = level;
    return loader_.load(robot_, selection, {package_path_});
  }

  /// Called from several threads.
  TriangleMesh imported(const MeshFile& file) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = read_.find(file.path);
    return found != read_.end() ? found->second : read_[file.path] = importMesh(file);
  }

  std::size_t bytesOf(const std::vector<BoundedLink>& parts) const {
    std::set<const PointSet*> seen{nullptr};
    for (const auto& [path, points] : whole_.meshes)
      seen.insert(points.get());
    std::size_t bytes = 0;
    for (const BoundedLink& part : parts) {
      for (const Shape& shape : part.shapes) {
        if (seen.insert(shape.points.get()).second) bytes += shape.points->bytes();
      }
    }
    return bytes;
  }

  double volumeOf(const std::vector<BoundedLink>& parts, const Eigen::Affine3d& pose) const {
    double sum = 0;
    for (const BoundedLink& part : parts) {
      const Eigen::Affine3d root_from_link(poses_.at(part.name).matrix());
      if (const auto box = linkBox(part, pose * root_from_link)) sum += box->volume();
    }
    return sum;
  }

  Robot robot_;
  PackagePath package_path_;
  std::map<std::string, Eigen::Isometry3d> poses_;
  std::mutex mutex_;
  std::map<std::string, TriangleMesh> read_;
  RobotLoader loader_{[this](const MeshFile& file) { return imported(file); }};
  BoundedRobot whole_;
};

/// The demo robot where there is no data.
std::vector<Model> models() {
  const auto folder = robotsFolder();
  if (!folder) {
    std::cout << "LINK_BOUNDS_DATA is not set: the demo robot stands in for robots and models\n";
    return {{"demo", demoRobot()}};
  }
  return {{"panda", robotFile(*folder, "franka_description/urdf/panda.urdf")},
          {"ur5e", robotFile(*folder, "ur_description/urdf/ur5e.urdf")},
          {"bunny", robotFile(*folder, "stanford_models/urdf/stanford_bunny.urdf")},
          {"dragon", robotFile(*folder, "stanford_models/urdf/dragon_vrip_res2.urdf")}};
}

Row rowOf(const std::string& model, const Parts& parts, const Parts& whole) {
  return {{"model", model},
          {"parts_per_link", parts.level},
          {"parts", parts.parts},
          {"volume", parts.volume},
          {"turned_volume", parts.turned_volume},
          {"bytes", parts.bytes},
          {"seconds", parts.seconds},
          {"volume_ratio", parts.volume / whole.volume},
          {"turned_volume_ratio", parts.turned_volume / whole.turned_volume},
          {"bytes_per_part", parts.bytes / std::max<std::size_t>(1, parts.parts)}};
}

Rows measureAll(int turns) {
  Rows rows;
  for (const auto& [name, file] : models()) {
    RestingRobot robot(file);
    const Parts whole = robot.measure(kLevels[0], turns);
    for (const int level : kLevels)
      rows.push_back(rowOf(name, level == 1 ? whole : robot.measure(level, turns), whole));
  }
  return rows;
}

/// One line per model, one column per level.
void printLevels(const std::string& title, const std::string& value, const Rows& rows) {
  std::vector<Column> columns{{"model", "", 8}};
  for (const int level : kLevels)
    columns.push_back({std::to_string(level)});
  printTable(title, columns, pivot(rows, {"model"}, "parts_per_link", value));
}

}  // namespace

Rows benchmarkParts(bool quick) {
  const Rows rows = measureAll(quick ? kFewTurns : kTurns);
  printLevels("sum of volumes, joints at 0, by parts_per_link", "volume_ratio", rows);
  printLevels("the same on average over 100 turns of the whole robot", "turned_volume_ratio", rows);
  printLevels("parts in all", "parts", rows);
  printLevels("bytes per part", "bytes_per_part", rows);
  printLevels("seconds, without reading the files", "seconds", rows);
  return rows;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How tight parts are, by the max number per link: parts_bench [--quick] [--json FILE]
#include <chrono>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <set>

#include "bench/common/benchmark_main.h"
#include "bench/common/machine.h"
#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/worker/mesh_import.h"
#include "testing/brute_force.h"
#include "testing/robot_files.h"

namespace link_bounds::bench {
namespace {

constexpr int kLevels[] = {1, 2, 4, 8, 16, 64};
constexpr int kTurns = 100;
constexpr int kFewTurns = 10;

struct Model {
  std::string name;
  RobotFile file;
};

struct Row {
  std::string model;
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

  Row measure(int level, int turns) {
    Row row;
    row.level = level;
    const auto start = std::chrono::steady_clock::now();
    const BoundedRobot robot = bounded(level);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::vector<BoundedLink> parts;
    for (const auto& of_link : robot.parts)
      parts.insert(parts.end(), of_link.begin(), of_link.end());
    if (level == 1) parts = robot.links;
    row.parts = parts.size();
    row.bytes = bytesOf(parts);
    row.volume = volumeOf(parts, Eigen::Affine3d::Identity());
    brute_force::Random random(1);
    for (int i = 0; i < turns; ++i)
      row.turned_volume += volumeOf(parts, random.rigid(0)) / turns;
    return row;
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
    return {{"demo", demoRobotFile(LINK_BOUNDS_PACKAGE "/launch/demo/demo.urdf")}};
  }
  return {{"panda", robotFile(*folder, "franka_description/urdf/panda.urdf")},
          {"ur5e", robotFile(*folder, "ur_description/urdf/ur5e.urdf")},
          {"bunny", robotFile(*folder, "stanford_models/urdf/stanford_bunny.urdf")},
          {"dragon", robotFile(*folder, "stanford_models/urdf/dragon_vrip_res2.urdf")}};
}

std::vector<Row> measureAll(int turns) {
  std::vector<Row> rows;
  for (const auto& [name, file] : models()) {
    RestingRobot robot(file);
    for (const int level : kLevels) {
      rows.push_back(robot.measure(level, turns));
      rows.back().model = name;
    }
  }
  return rows;
}

/// One line per model, one column per level. `entry(row, row of level 1)` prints a cell.
template <class Entry>
void printTable(const std::string& title, const std::vector<Row>& rows, Entry&& entry) {
  std::cout << "\n" << title << "\n\n| |";
  for (const int level : kLevels)
    std::cout << " " << level << " |";
  std::cout << "\n|---|";
  for (std::size_t i = 0; i < std::size(kLevels); ++i)
    std::cout << "---:|";
  const Row* first = nullptr;
  for (const Row& row : rows) {
    if (row.level == 1) {
      first = &row;
      std::cout << "\n| " << row.model << " |";
    }
    std::cout << " ";
    entry(row, *first);
    std::cout << " |";
  }
  std::cout << "\n";
}

void printTables(const std::vector<Row>& rows) {
  std::cout << std::fixed << std::setprecision(3);
  printTable("sum of volumes, joints at 0, by parts_per_link", rows,
             [](const Row& row, const Row& whole) { std::cout << row.volume / whole.volume; });
  printTable("the same on average over 100 turns of the whole robot", rows,
             [](const Row& row, const Row& whole) {
               std::cout << row.turned_volume / whole.turned_volume;
             });
  printTable("parts in all", rows, [](const Row& row, const Row&) { std::cout << row.parts; });
  printTable("bytes per part", rows, [](const Row& row, const Row&) {
    std::cout << row.bytes / std::max<std::size_t>(1, row.parts);
  });
  printTable("seconds, without reading the files", rows,
             [](const Row& row, const Row&) { std::cout << row.seconds; });
}

void writeJson(const std::vector<Row>& rows, std::ostream& out) {
  const char* separator = "[\n";
  out << std::setprecision(9);
  for (const Row& row : rows) {
    out << separator << "{\"model\": " << std::quoted(row.model)
        << ", \"parts_per_link\": " << row.level << ", \"parts\": " << row.parts
        << ", \"volume\": " << row.volume << ", \"turned_volume\": " << row.turned_volume
        << ", \"bytes\": " << row.bytes << ", \"seconds\": " << row.seconds << "}";
    separator = ",\n";
  }
  out << "\n]\n";
}

void benchmarkParts(bool quick, std::ostream* json) {
  std::cout << "CPU: " << cpuName() << "\n";
  const std::vector<Row> rows = measureAll(quick ? kFewTurns : kTurns);
  printTables(rows);
  if (json) writeJson(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkParts);
}

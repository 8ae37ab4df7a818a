// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Many poses of a robot as a program in C++ computes them, on one thread: FILE.urdf VALUES
// BOXES DISTANCES LIMIT. VALUES is a file of doubles, rows of the joints that can be set.
// Prints the processor seconds of the boxes of the first BOXES rows, and of the distances within
// LIMIT [m] of the first DISTANCES.
#include <algorithm>
#include <cstring>
#include <ctime>
#include <iostream>

#include "bench/common/processes.h"
#include "packages/package_path.h"
#include "robot/posed/posed_robot.h"
#include "testing/robot_files.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kBoxNumbers = 6;

class PoseRows {
 public:
  PoseRows(const Robot& robot, const std::string& file) : joint_count_(robot.joints.size()) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      if (hasValue(robot.joints[i].motion) && !robot.joints[i].mimic) joints_.push_back(i);
    }
    const std::string bytes = textOf(file);
    numbers_.resize(bytes.size() / sizeof(double));
    std::memcpy(numbers_.data(), bytes.data(), numbers_.size() * sizeof(double));
  }

  std::size_t count() const { return numbers_.size() / joints_.size(); }

  void pose(std::size_t row, PosedRobot& posed) const {
    std::vector<double> values(joint_count_, 0.0);
    for (std::size_t i = 0; i < joints_.size(); ++i)
      values[joints_[i]] = numbers_[row * joints_.size() + i];
    posed.move(std::move(values));
  }

 private:
  std::size_t joint_count_;
  std::vector<std::size_t> joints_;
  std::vector<double> numbers_;
};

double since(std::clock_t begin) {
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double secondsOfBoxes(const PoseRows& rows, std::size_t count, std::size_t links,
                      PosedRobot& posed) {
  std::vector<double> out(count * links * kBoxNumbers);
  const std::clock_t begin = std::clock();
  double* place = out.data();
  for (std::size_t row = 0; row < count; ++row) {
    rows.pose(row, posed);
    for (std::size_t link = 0; link < links; ++link, place += kBoxNumbers) {
      if (!posed.box(link)) continue;
      std::copy_n(posed.box(link)->min().data(), 3, place);
      std::copy_n(posed.box(link)->max().data(), 3, place + 3);
    }
  }
  return since(begin);
}

double secondsOfDistances(const PoseRows& rows, std::size_t count, double limit,
                          PosedRobot& posed) {
  std::vector<PoseDistances> found;
  const std::clock_t begin = std::clock();
  for (std::size_t row = 0; row < count; ++row) {
    rows.pose(row, posed);
    found.push_back(posed.distances(limit));
  }
  return since(begin);
}

}  // namespace

void poseRows(const Words& words) {
  Selection selection;
  selection.triangles = true;
  const auto [robot, bounded] = loadRobot(textOf(words[0]), {rosPackages()}, selection);
  if (!bounded.problems.empty()) throw std::runtime_error(bounded.problems.front());
  PosedRobot posed(robot, bounded);
  const PoseRows rows(posed.robot(), words[1]);
  const std::size_t boxes = std::min<std::size_t>(std::stoul(words[2]), rows.count());
  const std::size_t distances = std::min<std::size_t>(std::stoul(words[3]), rows.count());
  std::cout << secondsOfBoxes(rows, boxes, bounded.links.size(), posed) << ' ';
  std::cout << secondsOfDistances(rows, distances, std::stod(words[4]), posed) << '\n';
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes are means over random orientations or joint positions. The suite measures times.
#include "bench/volumes/volumes_measure.h"

#include <cmath>

#include "bench/common/poses.h"
#include "bench/common/suite.h"
#include "link_bounds/geometry/shape/link_boxes.h"
#include "link_bounds/geometry/volumes/bounding_sphere.h"
#include "link_bounds/geometry/volumes/oriented_box.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kOrientations = 500;
constexpr int kJointPositions = 100;
constexpr std::size_t kPairs = 256;  ///< a power of 2

using LinkValues = std::vector<double>;  ///< one per link of a robot

double sphereVolume(const BoundingSphere& sphere) {
  return 4.0 / 3 * M_PI * std::pow(sphere.radius, 3);
}

/// The mean volume of boxes along fixed axes while each link is turned at random.
LinkValues turnedVolumes(const MeasuredRobot& robot) {
  const Poses poses = randomPoses(kOrientations);
  LinkValues result;
  for (const BoundedLink& link : robot.links) {
    double sum = 0;
    for (const Eigen::Affine3d& pose : poses)
      sum += linkBox(link, pose)->volume();
    result.push_back(sum / static_cast<double>(kOrientations));
  }
  return result;
}

/// The same along the axes of the root link, with each joint anywhere in a full turn.
LinkValues jointVolumes(const MeasuredRobot& robot) {
  brute_force::Random random(1);
  LinkValues result(robot.links.size(), 0.0);
  for (int i = 0; i < kJointPositions; ++i) {
    std::map<std::string, double> values;
    for (const Joint& joint : robot.robot.joints) {
      if (joint.motion == Motion::kRotation) values[joint.name] = random.uniform(-M_PI, M_PI);
    }
    const auto poses = linkPoses(robot.robot, jointValues(robot.robot, values));
    for (std::size_t k = 0; k < result.size(); ++k) {
      const Eigen::Affine3d pose(poses[robot.indices[k]]);
      result[k] += linkBox(robot.links[k], pose)->volume() / kJointPositions;
    }
  }
  return result;
}

template <class VolumeOf>
LinkValues volumes(const MeasuredRobot& robot, const VolumeOf& volume_of) {
  LinkValues result;
  for (const BoundedLink& link : robot.links)
    result.push_back(volume_of(link));
  return result;
}

double meanRatio(const LinkValues& values, const LinkValues& reference) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += values[i] / reference[i];
  return sum / static_cast<double>(values.size());
}

Result row(const MeasuredRobot& robot, const std::string& method, double ratio) {
  return {robot.name, "robot", robot.links.size(), 0, method, std::nullopt, ratio, 0};
}

void addVolumes(const MeasuredRobot& robot, Results& results) {
  const LinkValues turned = turnedVolumes(robot);
  const auto add = [&](const char* method, const LinkValues& values) {
    results.push_back(row(robot, method, meanRatio(values, turned)));
  };
  add(kAabb, turned);
  add(kAabbAtJoints, jointVolumes(robot));
  add(kSphere,
      volumes(robot, [](const auto& link) { return sphereVolume(*boundingSphere(link)); }));
  add(kOrientedBox,
      volumes(robot, [](const auto& link) { return orientedBox(link)->size.prod(); }));
}

void addCase(const MeasuredRobot& robot, const char* method, std::size_t count,
             std::function<void(benchmark::State&)> body, Suite& suite) {
  suite.push_back({row(robot, method, std::nan("")), std::move(body), count});
}

/// Calls update(link, pose) for each link, under poses that turn at random.
template <class Pose, class Update>
std::function<void(benchmark::State&)> updates(std::size_t links, Update update) {
  std::vector<Pose> poses;
  for (const Eigen::Affine3d& pose : randomPoses(kRandomPoses))
    poses.emplace_back(pose.matrix());
  return [links, poses, update](benchmark::State& state) mutable {
    std::size_t next = 0;
    for (auto _ : state) {
      for (std::size_t i = 0; i < links; ++i)
        benchmark::DoNotOptimize(update(i, poses[next++ % kRandomPoses]));
    }
  };
}

template <class Volume>
std::vector<Volume> prepared(const MeasuredRobot& robot,
                             std::optional<Volume> (*prepare)(const BoundedLink&)) {
  std::vector<Volume> result;
  for (const BoundedLink& link : robot.links)
    result.push_back(*prepare(link));
  return result;
}

template <class Volume>
void addVolume(const MeasuredRobot& robot, const char* once, const char* update,
               std::optional<Volume> (*prepare)(const BoundedLink&), Suite& suite) {
  const std::size_t links = robot.links.size();
  const auto place = [volumes = prepared(robot, prepare)](std::size_t i,
                                                          const Eigen::Isometry3d& pose) {
    return placed(volumes[i], pose);
  };
  addCase(robot, update, links, updates<Eigen::Isometry3d>(links, place), suite);
  const auto body = [&robot, prepare](benchmark::State& state) {
    for (auto _ : state) {
      for (const BoundedLink& link : robot.links)
        benchmark::DoNotOptimize(prepare(link));
    }
  };
  addCase(robot, once, links, body, suite);
}

void addAabb(const MeasuredRobot& robot, Suite& suite) {
  const std::size_t links = robot.links.size();
  const auto update = [boxes = std::make_shared<LinkBoxes>(robot.links)](
                          std::size_t i, const Eigen::Affine3d& pose) {
    boxes->update(i, pose);
    return boxes->box(i);
  };
  addCase(robot, kAabb, links, updates<Eigen::Affine3d>(links, update), suite);
}

bool overlap(const Aabb& a, const Aabb& b) {
  return a.intersects(b);
}

bool overlap(const BoundingSphere& a, const BoundingSphere& b) {
  const double reach = a.radius + b.radius;
  return (a.center - b.center).squaredNorm() <= reach * reach;
}

template <class Volume>
void addOverlap(const MeasuredRobot& robot, const char* method, const std::vector<Volume>& volumes,
                Suite& suite) {
  const auto body = [volumes](benchmark::State& state) {
    for (auto _ : state) {
      for (std::size_t i = 0; i < kPairs; ++i)
        benchmark::DoNotOptimize(overlap(volumes[i], volumes[(i + 1) % kPairs]));
    }
  };
  addCase(robot, method, kPairs, body, suite);
}

void addOverlaps(const MeasuredRobot& robot, Suite& suite) {
  std::vector<Aabb> boxes;
  std::vector<BoundingSphere> spheres;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const BoundedLink& link = robot.links[i % robot.links.size()];
    const Eigen::Affine3d& pose = turningPoses()[i];
    boxes.push_back(*linkBox(link, pose));
    spheres.push_back(*placed(*boundingSphere(link), Eigen::Isometry3d(pose.matrix())));
  }
  addOverlap(robot, kOverlapAabb, boxes, suite);
  addOverlap(robot, kOverlapSphere, spheres, suite);
}

}  // namespace

Results measureVolumes(const std::vector<MeasuredRobot>& robots, bool is_quick) {
  Suite suite;
  Results results;
  for (const MeasuredRobot& robot : robots) {
    addVolumes(robot, results);
    addAabb(robot, suite);
    addVolume(robot, kPrepareSphere, kSphere, boundingSphere, suite);
    addVolume(robot, kPrepareOrientedBox, kOrientedBox, orientedBox, suite);
    addOverlaps(robot, suite);
  }
  const Results times = run(suite, is_quick ? 3 : 11, is_quick ? 0.005 : 0.01);
  results.insert(results.end(), times.begin(), times.end());
  for (Result& result : results)
    if (!std::isnan(result.volume_ratio)) result.ns = std::nan("");
  return results;
}

}  // namespace link_bounds::bench

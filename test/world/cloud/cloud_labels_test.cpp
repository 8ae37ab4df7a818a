// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels of the points that rays measure of moving robots and a scene, each ray at its own time of
// a random tf history. The label is what the ray hit.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "link_bounds/geometry/distance/body_distance.h"
#include "testing/robot_files.h"
#include "testing/scanned_robot.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr double kPadding = 0.01;
constexpr double kBegin = 1000;               // s
constexpr std::uint32_t kScan = 100'000'000;  // ns
constexpr double kSpeed = 2;                  // rad/s
constexpr int kUsualRays = 400;               // per robot; with more, grids have their full size

struct Labels {
  std::size_t robot = 0, scene = 0;  ///< points that rays hit
  std::size_t near = 0;              ///< of the scene, within padding and motion error of a link
  std::size_t kept_robot = 0, lost_scene = 0;
  std::size_t between = 0, lost_between = 0;  ///< points between two fingers
  double error = 0;                           ///< of the motion [m]
};

struct LabelledPoint {
  CloudPoint point;
  bool is_robot;
  bool is_between = false;
};

class Generator {
 public:
  Generator(ScannedRobot& scanned, Random& random) : scanned_(scanned), random_(random) {
    placeSensor();
    for (int i = 0; i < 12; ++i) {
      Eigen::Affine3d pose = random.rigid(0.5 * size_);
      pose.translation() += center_;
      scanned_.addScene(
          boxBody(Eigen::Vector3d::Constant(0.1) + random.vector(0.05).cwiseAbs(), pose));
    }
    scanned_.addScene(boxBody({20, 20, 0.1}, Eigen::Affine3d(Eigen::Translation3d(0, 0, -0.05))));
  }

  /// Rays that hit the robot or the scene, in groups of one time.
  std::vector<LabelledPoint> rays(std::size_t count) {
    std::vector<LabelledPoint> points;
    while (points.size() < count) {
      const auto time = static_cast<std::uint32_t>(random_.uniform(0, kScan));
      const ScannedRobot::Ray ray(scanned_, stampOf(time));
      for (int i = 0; i < 20; ++i) {
        const Eigen::Vector3d direction =
            i % 2 == 0 ? towardsALink(time) : towardsTheScene(ray.root_from_sensor);
        if (const auto hit = ray.cast(direction)) points.push_back(measured(*hit, direction, time));
      }
    }
    return points;
  }

  /// Points on the way from one link to another.
  std::vector<LabelledPoint> between(const std::string& a, const std::string& b) {
    std::vector<LabelledPoint> points;
    for (int i = 0; i < 200; ++i) {
      const auto time = static_cast<std::uint32_t>(random_.uniform(0, kScan));
      const double part = random_.uniform(0, 1);
      const Eigen::Vector3d place = (1 - part) * centerOf(a, time) + part * centerOf(b, time);
      points.push_back({toPoint(place, time), false, true});
    }
    return points;
  }

 private:
  static std::int64_t stampOf(std::uint32_t time) {
    return static_cast<std::int64_t>(ros::Time(kBegin).toNSec()) + time;
  }

  static CloudPoint toPoint(const Eigen::Vector3d& place, std::uint32_t time) {
    const Eigen::Vector3f rounded = place.cast<float>();
    return {rounded.x(), rounded.y(), rounded.z(), time};
  }

  LabelledPoint measured(const ScannedRobot::Hit& hit, const Eigen::Vector3d& direction,
                         std::uint32_t time) {
    const double noise = random_.uniform(-0.999, 0.999) * kPadding;
    return {toPoint((hit.range + noise) * direction, time), hit.is_robot};
  }

  Eigen::Vector3d centerOf(const std::string& link, std::uint32_t time) const {
    const auto found = std::find(scanned_.names.begin(), scanned_.names.end(), link);
    const auto index = static_cast<std::size_t>(found - scanned_.names.begin());
    return scanned_.linkFromSensor(index, stampOf(time)).inverse() *
           scanned_.grids[index]->surface().box().center();
  }

  Eigen::Vector3d towardsALink(std::uint32_t time) {
    const double count = static_cast<double>(scanned_.names.size());
    const auto link = static_cast<std::size_t>(random_.uniform(0, count));
    return (centerOf(scanned_.names[link], time) + random_.vector(0.1)).normalized();
  }

  Eigen::Vector3d towardsTheScene(const Eigen::Affine3d& root_from_sensor) {
    return (root_from_sensor.inverse() * (center_ + random_.vector(0.55 * size_))).normalized();
  }

  /// Where it sees the whole robot; then the robot moves.
  void placeSensor() {
    Aabb box;
    const auto poses = linkPoses(scanned_.robot, jointValues(scanned_.robot, {}));
    for (const Eigen::Isometry3d& pose : poses)
      box.extend(pose.translation());
    center_ = box.center();
    size_ = box.sizes().maxCoeff() + 0.3;
    Eigen::Vector3d way = random_.vector(1).normalized();
    way.z() = std::abs(way.z());
    scanned_.move(random_, kSpeed, kBegin - 0.05, kBegin + 0.15,
                  lookingAt(center_ + 1.5 * size_ * way, center_));
  }

  ScannedRobot& scanned_;
  Random& random_;
  Eigen::Vector3d center_;
  double size_ = 1;
};

/// Bounds of the distance from the nearest link at the point's own time, by another algorithm than
/// that of the grid: GJK and trees of triangles.
PointDistance trueDistance(const ScannedRobot& scanned, const Eigen::Vector3d& place,
                           std::int64_t stamp) {
  PointDistance best{1e9, 1e9};
  const Body dot{{BodyShape()}};
  for (std::size_t i = 0; i < scanned.links.size(); ++i) {
    const Eigen::Vector3d in_link = scanned.linkFromSensor(i, stamp) * place;
    if (scanned.grids[i]->surface().box().squaredExteriorDistance(in_link) > 1e-3) continue;
    const auto found = bodyDistance(scanned.bodies[i], Eigen::Affine3d::Identity(), dot,
                                    Eigen::Affine3d(Eigen::Translation3d(in_link)), {1e-7});
    if (!found) continue;
    const bool is_inside = scanned.grids[i]->surface().contains(in_link).value_or(true);
    best.lower = std::min(best.lower, is_inside ? 0 : found->lower);
    best.upper = std::min(best.upper, is_inside ? 0 : found->upper);
  }
  return best;
}

Labels compare(const ScannedRobot& scanned, const std::vector<LabelledPoint>& points) {
  std::vector<CloudPoint> places;
  for (const LabelledPoint& point : points)
    places.push_back(point.point);
  const sensor_msgs::PointCloud2 cloud =
      cloudOfPoints(places, static_cast<std::uint32_t>(places.size()), kBegin);
  const CloudLayout layout = layoutOf(cloud);
  EXPECT_EQ(layout.problem, "");
  const ScanPoses poses =
      scanPoses(scanned.tf, *scanned.tf.find("sensor"), scanned.links, *timeSpan(layout.points));
  EXPECT_EQ(poses.problem, "");
  Labels result;
  for (const LinkMotion& link : poses.links)
    result.error = std::max(result.error, link.error);
  std::vector<bool> is_removed(points.size(), false);
  for (const RobotPoint& found : robotPoints({layout.points, scanned.grids, poses}))
    is_removed[found.point] = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LabelledPoint& point = points[i];
    if (point.is_robot) {
      ++result.robot;
      result.kept_robot += !is_removed[i];
      continue;
    }
    const std::uint8_t* bytes = layout.points.point(i);
    const PointDistance distance =
        trueDistance(scanned, layout.points.position(bytes), layout.points.timeOf(bytes));
    const bool is_far = distance.lower > kPadding + result.error + 1e-9;
    result.kept_robot += !is_removed[i] && distance.upper < kPadding - 1e-6;
    (point.is_between ? result.between : result.scene) += is_far || !point.is_between;
    result.near += !is_far && !point.is_between;
    (point.is_between ? result.lost_between : result.lost_scene) += is_far && is_removed[i];
  }
  return result;
}

/// Rows as doc/clouds.md has them.
void printHeader() {
  std::cout
      << "| robot | points of the robot | of them kept | points of the scene, farther than the "
         "padding | of them lost | points between the fingers | of them lost | error of the "
         "motion |\n|---|---|---|---|---|---|---|---|\n";
}

void expectRight(const std::string& name, const Labels& labels, std::size_t rays) {
  const std::size_t far = labels.scene - labels.near;
  std::cout << "| " << name << " | " << labels.robot << " | " << labels.kept_robot << " | " << far
            << " | " << labels.lost_scene << " | " << labels.between << " | " << labels.lost_between
            << " | " << std::fixed << std::setprecision(2) << labels.error * 1e3 << " mm |\n"
            << std::flush;
  EXPECT_EQ(labels.kept_robot, 0u) << name;
  EXPECT_EQ(labels.lost_scene, 0u) << name;
  EXPECT_EQ(labels.lost_between, 0u) << name;
  EXPECT_GT(labels.robot, rays / 10) << name;
  EXPECT_GT(far, rays / 5) << name;
}

using Fingers = std::pair<std::string, std::string>;

const std::map<std::string, Fingers> kFingers{
    {"demo", {"finger_left", "finger_right"}},
    {"panda", {"panda_leftfinger", "panda_rightfinger"}},
    {"pr2", {"r_gripper_l_finger_tip_link", "r_gripper_r_finger_tip_link"}},
    {"gen3_robotiq_2f_85", {"left_inner_finger_pad", "right_inner_finger_pad"}}};

void checkRobot(const RobotFile& file, std::size_t rays, std::uint64_t seed) {
  Random random(seed);
  ScannedRobot scanned(file, kPadding);
  scanned.makeGrids(kIsSanitized || rays <= std::size_t{kUsualRays});
  Generator generator(scanned, random);
  std::vector<LabelledPoint> points = generator.rays(rays);
  const auto fingers = kFingers.find(file.name());
  const auto knows = [&](const std::string& name) {
    return std::find(scanned.names.begin(), scanned.names.end(), name) != scanned.names.end();
  };
  const bool has_fingers =
      fingers != kFingers.end() && knows(fingers->second.first) && knows(fingers->second.second);
  if (has_fingers) {
    const auto more = generator.between(fingers->second.first, fingers->second.second);
    points.insert(points.end(), more.begin(), more.end());
  }
  const Labels labels = compare(scanned, points);
  expectRight(file.name(), labels, rays);
  if (has_fingers) {
    EXPECT_GT(labels.between, 5u);
  }
}

/// Per robot; another number for a long run.
std::size_t raysOr(int usual) {
  const char* const rays = std::getenv("LINK_BOUNDS_CLOUD_RAYS");
  return rays ? static_cast<std::size_t>(std::atoll(rays))
              : static_cast<std::size_t>(repetitions(usual));
}

TEST(CloudLabels, OfTheDemoRobotAreWhatTheRaysHit) {
  printHeader();
  checkRobot(demoRobotFile(), raysOr(kUsualRays), 1);
}

TEST(CloudLabels, OfPublicRobotsAreWhatTheRaysHit) {
  const std::vector<RobotFile> files = publicRobotFiles();
  if (files.empty())
    GTEST_SKIP() << "skipped: clouds of public robots: LINK_BOUNDS_DATA is not set";
  printHeader();
  std::uint64_t seed = 2;
  for (const RobotFile& file : files)
    checkRobot(file, raysOr(kUsualRays), seed++);
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels of points while robot and sensor move, beside tf2's pose at each point's own time and a
// comparison with every triangle in long double.
#include "world/cloud/robot_points.h"

#include <gtest/gtest.h>

#include <iostream>

#include "testing/distance_bodies.h"
#include "testing/live_boxes_testing.h"
#include "testing/ordinary_user.h"
#include "testing/sanitized.h"
#include "world/cloud/nearest_points.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using distance_oracle::Long;

constexpr double kPadding = 0.01;
constexpr double kBegin = 1000;  // s

/// A point that is farther than padding and this from all links is never removed [m].
constexpr double kPromised = 1e-3;

struct TestPoint {
  Eigen::Vector3d place;  ///< in the sensor's frame
  std::uint32_t time;     ///< after kBegin [ns]
};

sensor_msgs::PointCloud2 cloudOf(const std::vector<TestPoint>& points) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(kBegin);
  cloud.header.frame_id = "sensor";
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.point_step = 28;
  cloud.row_step = cloud.width * cloud.point_step;
  const auto add = [&](const char* name, std::uint32_t offset, std::uint8_t type) {
    cloud.fields.emplace_back();
    cloud.fields.back().name = name;
    cloud.fields.back().offset = offset;
    cloud.fields.back().datatype = type;
    cloud.fields.back().count = 1;
  };
  add("x", 0, sensor_msgs::PointField::FLOAT64);
  add("y", 8, sensor_msgs::PointField::FLOAT64);
  add("z", 16, sensor_msgs::PointField::FLOAT64);
  add("t", 24, sensor_msgs::PointField::UINT32);
  cloud.data.resize(cloud.row_step);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint8_t* bytes = cloud.data.data() + i * cloud.point_step;
    std::memcpy(bytes, points[i].place.data(), 24);
    std::memcpy(bytes + 24, &points[i].time, 4);
  }
  return cloud;
}

/// The links of a robot that moves before a sensor that moves, too.
class Scanned {
 public:
  void add(const std::string& frame, const Body& body,
           std::vector<distance_oracle::Triangle> triangles) {
    const TransformBuffer::Frame number = tf.frame(frame);
    grids.push_back(std::make_shared<BodyGrid>(
        BodySurface(body),
        GridOptions{kPadding, kMaxMotionError, (kIsSanitized ? 16 : 256) * 1024u}));
    links.push_back({number, grids.back()->box()});
    bodies.push_back(body);
    all_triangles.push_back(std::move(triangles));
  }

  /// The edge turns at up to `speed` [rad/s] about any axis, at 50 Hz, and not quite evenly.
  void move(Random& random, const std::string& parent, const std::string& child,
            const Eigen::Vector3d& place, double speed) {
    const Eigen::Vector3d axis = random.vector(1).normalized();
    double angle = random.uniform(-3, 3);
    for (double stamp = kBegin - 0.03; stamp < kBegin + 0.2; stamp += 0.02) {
      tf.add({edge(parent, child, stamp, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)),
                   place + 0.05 * angle * axis)},
             false, ros::Time(kBegin + 1));
      angle += 0.02 * speed * random.uniform(0.3, 1);
    }
  }

  Eigen::Affine3d linkFromSensor(std::size_t link, std::int64_t stamp) const {
    const auto pose = tf.pose(links[link].frame, *tf.find("sensor"), stamp);
    return MatrixPose(*pose).affine;
  }

  ScanPoses poses(TimeSpan span) { return scanPoses(tf, tf.frame("sensor"), links, span); }

  TransformBuffer tf;
  std::vector<std::shared_ptr<const BodyGrid>> grids;
  std::vector<ScannedLink> links;
  std::vector<Body> bodies;
  std::vector<std::vector<distance_oracle::Triangle>> all_triangles;
};

std::int64_t stampOf(const TestPoint& point) {
  return static_cast<std::int64_t>(ros::Time(kBegin).toNSec()) + point.time;
}

/// Bounds of the distance from the nearest link at the point's time: by another algorithm than that
/// of the grid, and near the border by all triangles in long double.
PointDistance trueDistance(const Scanned& scanned, const TestPoint& point) {
  PointDistance best{1e9, 1e9};
  const Body dot{{BodyShape()}};
  for (std::size_t i = 0; i < scanned.links.size(); ++i) {
    const Eigen::Vector3d place = scanned.linkFromSensor(i, stampOf(point)) * point.place;
    const auto found = bodyDistance(scanned.bodies[i], Eigen::Affine3d::Identity(), dot,
                                    Eigen::Affine3d(Eigen::Translation3d(place)), {1e-6});
    PointDistance distance{found->lower, found->upper};
    if (std::abs(distance.lower - kPadding) < 2e-3 && !scanned.all_triangles[i].empty()) {
      Long exact = 1e9;
      for (const auto& triangle : scanned.all_triangles[i])
        exact = std::min(exact, distance_oracle::distance<Long>(place.cast<Long>(), triangle));
      EXPECT_GE(static_cast<double>(exact), distance.lower - 1e-9);
      distance = {static_cast<double>(exact), static_cast<double>(exact)};
    }
    best = {std::min(best.lower, distance.lower), std::min(best.upper, distance.upper)};
  }
  return best;
}

/// A point that the sensor sees of a link, with noise up to `noise` [m].
TestPoint seen(const Scanned& scanned, Random& random, double noise) {
  const auto link =
      static_cast<std::size_t>(random.uniform(0, static_cast<double>(scanned.links.size()) - 1e-9));
  const auto& triangles = scanned.all_triangles[link];
  const auto& corners = triangles[static_cast<std::size_t>(
      random.uniform(0, static_cast<double>(triangles.size()) - 1e-9))];
  const Long s = random.uniform(0, 1), t = random.uniform(0, 1 - static_cast<double>(s));
  const distance_oracle::Vector on_link =
      corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
  Eigen::Vector3d place = on_link.cast<double>();
  place += random.uniform(0, noise) * random.vector(1).normalized();
  TestPoint point{{}, static_cast<std::uint32_t>(random.uniform(0, 1e8))};
  point.place = scanned.linkFromSensor(link, stampOf(point)).inverse() * place;
  return point;
}

struct Result {
  std::size_t robot = 0, scene = 0, between = 0;
  int kept_robot = 0, lost_scene = 0;
  double error = 0;  ///< the largest motion error [m]
  std::size_t moments = 0;
};

/// The labels of `points`; no point of a closed mesh's inside may be among them.
Result compare(Scanned& scanned, const std::vector<TestPoint>& points, std::size_t threads = 1) {
  const sensor_msgs::PointCloud2 cloud = cloudOf(points);
  const CloudLayout layout = layoutOf(cloud);
  EXPECT_EQ(layout.problem, "");
  const ScanPoses poses = scanned.poses(*timeSpan(layout.points));
  EXPECT_EQ(poses.problem, "");
  Result result;
  result.moments = poses.moments.size();
  for (const LinkMotion& link : poses.links)
    result.error = std::max(result.error, link.error);
  EXPECT_LE(result.error, kMaxMotionError);
  EXPECT_LE(2 * result.error, kPromised);  // one of the point, and one that the padding grows by
  std::vector<bool> is_robot(points.size(), false);
  for (const RobotPoint& found : robotPoints({layout.points, scanned.grids, poses}, threads))
    is_robot[found.point] = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointDistance distance = trueDistance(scanned, points[i]);
    if (distance.upper <= kPadding - 1e-9) {
      ++result.robot;
      result.kept_robot += !is_robot[i];
    } else if (distance.lower > kPadding + result.error + 1e-9) {
      ++result.scene;
      result.lost_scene += is_robot[i];
    } else {
      ++result.between;
    }
  }
  return result;
}

void expectRight(const Result& result, const std::string& what) {
  EXPECT_EQ(result.kept_robot, 0) << what;
  EXPECT_EQ(result.lost_scene, 0) << what;
  std::cout << what << ": robot " << result.robot << " kept " << result.kept_robot << ", scene "
            << result.scene << " lost " << result.lost_scene << ", within the error "
            << result.between << ", " << result.moments << " moments, error " << result.error * 1e3
            << " mm\n";
}

/// Flat triangles without an inside, so that the distance alone decides.
MeshBody sheet(Random& random) {
  std::vector<Eigen::Vector3f> vertices;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d place = random.vector(0.2);
    for (int k = 0; k < 3; ++k)
      vertices.push_back((place + random.vector(0.05)).cast<float>());
  }
  MeshBody body;
  body.add(meshOf(vertices));
  return body;
}

void addArm(Scanned& scanned, Random& random, double speed) {
  scanned.move(random, "world", "sensor", {0, 0, 1}, speed / 4);
  std::string parent = "world";
  for (const char* child : {"one", "two", "three"}) {
    scanned.move(random, parent, child, 0.4 * random.vector(1), speed);
    const MeshBody body = sheet(random);
    scanned.add(child, body.body, body.placed(Eigen::Affine3d::Identity()));
    parent = child;
  }
}

std::vector<TestPoint> pointsAround(const Scanned& scanned, Random& random, int count) {
  std::vector<TestPoint> points;
  for (int i = 0; i < count; ++i)
    points.push_back(seen(scanned, random, i % 2 == 0 ? kPadding : 0.1));
  return points;
}

TEST(RobotPoints, AreThoseOfTheMovingRobotAtEachPointsOwnTime) {
  for (std::uint64_t seed = 1; seed <= (kIsSanitized ? 2u : 4u); ++seed) {
    Random random(seed);
    Scanned scanned;
    addArm(scanned, random, 2);
    const Result result = compare(scanned, pointsAround(scanned, random, 3000), 1 + seed % 2);
    expectRight(result, "arm " + std::to_string(seed));
    EXPECT_GT(result.robot, 1000u);
    EXPECT_GT(result.scene, 500u);
    EXPECT_GT(result.error, 0);
  }
}

/// Interpolated, a point outside the box goes the chord of its way, which is nearer to the box.
TEST(RobotPoints, OutsideTheArcOfALinkAreKept) {
  Scanned scanned;
  const auto turned = [&](double stamp, double angle) {
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    scanned.tf.add({edge("world", "sensor", stamp, Eigen::Quaterniond::Identity(), {0, 0, 0}),
                    edge("world", "one", stamp, rotation, {0, 0, 0})},
                   false, ros::Time(kBegin + 1));
  };
  turned(kBegin, -0.04);
  turned(kBegin + 0.05, 0.04);
  MeshBody body;
  body.add(boxMesh({0.02, 0.02, 0.02}), Eigen::Affine3d(Eigen::Translation3d(1, 0, 0)));
  scanned.add("one", body.body, body.placed(Eigen::Affine3d::Identity()));
  std::vector<TestPoint> points{{{5, 0, 0}, 0}, {{5, 0, 0}, 50000000}};
  for (double beyond = -0.002; beyond < 0.0025; beyond += 0.0001)
    points.push_back({{1.01 + kPadding + beyond, 0, 0}, 25000000});
  const sensor_msgs::PointCloud2 cloud = cloudOf(points);
  const CloudLayout layout = layoutOf(cloud);
  const ScanPoses poses = scanned.poses(*timeSpan(layout.points));
  ASSERT_EQ(poses.problem, "");
  std::size_t removed = 0;
  for (const RobotPoint& found : robotPoints({layout.points, scanned.grids, poses})) {
    EXPECT_LE(trueDistance(scanned, points[found.point]).lower, kPadding + kPromised);
    ++removed;
  }
  EXPECT_GE(removed, 20u);  // up to the padding
}

TEST(RobotPoints, OfARobotAtRestHaveNoError) {
  Random random(9);
  Scanned scanned;
  addArm(scanned, random, 0);
  const Result result = compare(scanned, pointsAround(scanned, random, 2000));
  expectRight(result, "at rest");
  EXPECT_LT(result.error, 1e-6);
}

TEST(RobotPoints, BehindTheEndOfTfMayCome) {
  Random random(3);
  Scanned scanned;
  addArm(scanned, random, 1);
  const auto begin = static_cast<std::int64_t>(ros::Time(kBegin).toNSec());
  const ScanPoses late = scanned.poses({begin, begin + 1000000000});
  EXPECT_NE(late.problem, "");
  EXPECT_TRUE(late.may_come);
  const ScanPoses endless = scanned.poses({begin, begin + 6000000000});
  EXPECT_NE(endless.problem, "");
  EXPECT_FALSE(endless.may_come);
}

bool areEqual(const std::vector<RobotPoint>& a, const std::vector<RobotPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const RobotPoint& x, const RobotPoint& y) {
                      return x.point == y.point && x.link == y.link;
                    });
}

TEST(RobotPoints, AreTheSameOnAnyNumberOfThreadsAndWhereNoneCanStart) {
  Random random(8);
  Scanned scanned;
  addArm(scanned, random, 1);
  const sensor_msgs::PointCloud2 cloud = cloudOf(pointsAround(scanned, random, 200));
  const CloudLayout layout = layoutOf(cloud);
  const ScanPoses poses = scanned.poses(*timeSpan(layout.points));
  const PointQuery query{layout.points, scanned.grids, poses};
  const std::vector<RobotPoint> expected = robotPoints(query, 1);
  EXPECT_FALSE(expected.empty());
  EXPECT_TRUE(areEqual(robotPoints(query, 3), expected));
  EXPECT_TRUE(areEqual(robotPoints(query, 1000), expected));
  EXPECT_TRUE(isTrueWithoutThreads([&] { return areEqual(robotPoints(query, 3), expected); }));
}

TEST(RobotPoints, NearTheSensorCountIfAsked) {
  Random random(4);
  Scanned scanned;
  addArm(scanned, random, 0);
  const sensor_msgs::PointCloud2 cloud = cloudOf({{{0.1, 0, 30}, 0}, {{0, 0.01, 0}, 0}});
  const CloudLayout layout = layoutOf(cloud);
  const ScanPoses poses = scanned.poses(*timeSpan(layout.points));
  const auto far = robotPoints({layout.points, scanned.grids, poses, 0.2});
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].point, 1u);
}

TEST(RobotPoints, OfALinkThatTurnsRoundBetweenTwoMessagesAreRightOrRefused) {
  int refused = 0;
  for (const double turn : {M_PI - 1e-3, M_PI, M_PI + 1e-3, 3.0}) {
    for (const double step : {0.02, 1e-9}) {
      Random random(5);
      Scanned scanned;
      const MeshBody body = sheet(random);
      scanned.tf.add(
          {edge("world", "sensor", kBegin - 1, Eigen::Quaterniond::Identity(), {0, 0, 1}),
           edge("world", "sensor", kBegin + 1, Eigen::Quaterniond::Identity(), {0, 0, 1})},
          false, ros::Time(kBegin + 1));
      double angle = 0.3;
      for (const double stamp : {kBegin - 0.1, kBegin + 0.05, kBegin + 0.05 + step, kBegin + 0.2}) {
        const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle, Eigen::Vector3d(0.6, 0, 0.8)));
        scanned.tf.add({edge("world", "one", stamp, rotation, {0.3, 0, 0})}, false,
                       ros::Time(kBegin + 1));
        if (stamp >= kBegin + 0.05 - 1e-6 && stamp < kBegin + 0.05 + step / 2) angle += turn;
      }
      scanned.add("one", body.body, body.placed(Eigen::Affine3d::Identity()));
      const std::vector<TestPoint> points = pointsAround(scanned, random, 300);
      const auto begin = static_cast<std::int64_t>(ros::Time(kBegin).toNSec());
      const ScanPoses poses = scanned.poses({begin, begin + 100000000});
      if (!poses.problem.empty()) {
        EXPECT_FALSE(poses.may_come);
        ++refused;
        continue;
      }
      expectRight(compare(scanned, points), "turned by " + std::to_string(turn));
    }
  }
  std::cout << refused << " of 8 refused\n";
}

TEST(RobotPoints, OfFiveMillionPointsAreFound) {
  Random random(6);
  Scanned scanned;
  addArm(scanned, random, 0);
  const std::vector<TestPoint> some = pointsAround(scanned, random, 1000);
  std::vector<TestPoint> many(5000000, TestPoint{{50, 0, 0}, 0});
  for (std::size_t i = 0; i < some.size(); ++i)
    many[i * 5000] = some[i];
  const sensor_msgs::PointCloud2 small = cloudOf(some), large = cloudOf(many);
  const CloudPoints few_points = layoutOf(small).points, all_points = layoutOf(large).points;
  const ScanPoses poses = scanned.poses(*timeSpan(few_points));
  const auto expected = robotPoints({few_points, scanned.grids, poses});
  const auto found = robotPoints({all_points, scanned.grids, poses}, 2);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i].point, 5000 * expected[i].point);
}

/// One link at rest, a metre before the sensor.
void placeBefore(const Body& body, Scanned& scanned) {
  scanned.tf.add({edge("sensor", "plate", 0, Eigen::Quaterniond::Identity(), {0, 0, 1})}, true,
                 ros::Time(kBegin));
  scanned.add("plate", body, {});
}

std::vector<std::size_t> shadowOf(Scanned& scanned, const std::vector<TestPoint>& points,
                                  double min_distance = 0) {
  const sensor_msgs::PointCloud2 cloud = cloudOf(points);
  const CloudLayout layout = layoutOf(cloud);
  const ScanPoses poses = scanned.poses(*timeSpan(layout.points));
  EXPECT_EQ(poses.problem, "");
  std::vector<std::size_t> result;
  for (const RobotPoint& found :
       robotPoints({layout.points, scanned.grids, poses, min_distance, true}))
    result.push_back(found.point);
  return result;
}

TEST(RobotPoints, BehindALinkAreItsShadowIfAsked) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<TestPoint> points{{{0.11, 0.02, 2}, 0}, {{0.3, 0.02, 2}, 0},
                                      {{0, 0.01, 0.5}, 0},  {{-0.1, 0.01, 50}, 0},
                                      {{0, 0, -2}, 0},      {{nan, 0, 2}, 0}};
  const std::vector<std::size_t> behind{0, 3};
  MeshBody mesh, sheet;
  mesh.add(boxMesh({0.2, 0.2, 0.02}));
  sheet.add(meshOf({{-0.2f, -0.2f, 0}, {0.2f, -0.2f, 0}, {0, 0.3f, 0}}));
  const Body solid{{{{nullptr, Solid::kBox, {0.2, 0.2, 0.02}}}}};
  for (const Body& body : {mesh.body, sheet.body, solid}) {
    Scanned scanned;
    placeBefore(body, scanned);
    EXPECT_EQ(shadowOf(scanned, points), behind);
    // What is too near to be seen hides nothing.
    EXPECT_EQ(shadowOf(scanned, points, 1.4), std::vector<std::size_t>({2}));
  }
  // The sensor's own housing hides nothing.
  MeshBody housing;
  housing.add(boxMesh({0.2, 0.2, 2.1}));
  Scanned scanned;
  placeBefore(housing.body, scanned);
  EXPECT_EQ(shadowOf(scanned, {{{0, 0, 3}, 0}, {{0.01, 0, 1.5}, 0}}),
            std::vector<std::size_t>({1}));
}

TEST(NearestPoints, AreProvenBesideAllPoints) {
  for (const double speed : {0.0, 2.0}) {
    Random random(7);
    Scanned scanned;
    addArm(scanned, random, speed);
    const std::vector<TestPoint> points = pointsAround(scanned, random, 400);
    const sensor_msgs::PointCloud2 cloud = cloudOf(points);
    const CloudPoints places = layoutOf(cloud).points;
    const ScanPoses poses = scanned.poses(*timeSpan(places));
    const std::vector<RobotPoint> removed = robotPoints({places, scanned.grids, poses});
    std::vector<bool> is_removed(points.size(), false);
    for (const RobotPoint& point : removed)
      is_removed[point.point] = true;
    const NearestPoints found = nearestPoints(
        {places, removed, scanned.grids, scanned.links, scanned.tf, scanned.tf.frame("sensor")});
    ASSERT_EQ(found.problem, "");
    const Body dot{{BodyShape()}};
    for (std::size_t link = 0; link < scanned.links.size(); ++link) {
      const auto distanceOf = [&](const Eigen::Vector3d& place, std::int64_t stamp) {
        const Eigen::Vector3d in_link = scanned.linkFromSensor(link, stamp) * place;
        return *bodyDistance(scanned.bodies[link], Eigen::Affine3d::Identity(), dot,
                             Eigen::Affine3d(Eigen::Translation3d(in_link)), {1e-7});
      };
      double lower = 1e9, upper = 1e9;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (is_removed[i]) continue;
        const auto distance = distanceOf(points[i].place, stampOf(points[i]));
        lower = std::min(lower, distance.lower);
        upper = std::min(upper, distance.upper);
      }
      ASSERT_TRUE(found.links[link]);
      const NearestPoint& nearest = *found.links[link];
      EXPECT_FALSE(is_removed[nearest.point]);
      EXPECT_LE(nearest.lower, upper + 1e-9);
      EXPECT_GE(nearest.lower, lower - (speed > 0 ? 2 * kMaxMotionError : 1e-6));
      EXPECT_GE(nearest.upper, lower - 1e-9);
      EXPECT_LE(nearest.upper, upper + (speed > 0 ? 2 * kMaxMotionError : 1e-6));
      EXPECT_NEAR((nearest.on_cloud - nearest.on_link).norm(), nearest.upper, 1e-9);
      EXPECT_LT(distanceOf(nearest.on_link, nearest.stamp).lower, 1e-6);
      EXPECT_TRUE(nearest.is_of_mesh);
    }
  }
}

/// Whatever the order in which they come.
TEST(NearestPoints, OfALongCloudAreTheNearest) {
  constexpr std::size_t count = 1000;
  Scanned scanned;
  placeBefore({{{{nullptr, Solid::kBox, {0.2, 0.2, 0.02}}}}}, scanned);
  for (const std::size_t nearest : {std::size_t{0}, count / 2, count - 1}) {
    std::vector<TestPoint> points;
    for (std::size_t i = 0; i < count; ++i) {
      const double steps = static_cast<double>(i > nearest ? i - nearest : nearest - i);
      points.push_back({{0, 0, 1.11 + 0.002 * steps}, 0});
    }
    const sensor_msgs::PointCloud2 cloud = cloudOf(points);
    const CloudPoints places = layoutOf(cloud).points;
    const NearestPoints found = nearestPoints(
        {places, {}, scanned.grids, scanned.links, scanned.tf, scanned.tf.frame("sensor")});
    ASSERT_TRUE(found.links.at(0));
    EXPECT_EQ(found.links[0]->point, nearest);
    EXPECT_NEAR(found.links[0]->lower, 0.1, 1e-6);
  }
}

TEST(NearestPoints, OfACloudWithoutPointsAreNone) {
  Scanned scanned;
  placeBefore({{{{nullptr, Solid::kBox, {0.2, 0.2, 0.02}}}}}, scanned);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& points : {std::vector<TestPoint>{}, std::vector<TestPoint>{{{nan, 0, 0}, 0}}}) {
    const sensor_msgs::PointCloud2 cloud = cloudOf(points);
    const CloudPoints places = layoutOf(cloud).points;
    const NearestPoints found = nearestPoints(
        {places, {}, scanned.grids, scanned.links, scanned.tf, scanned.tf.frame("sensor")});
    EXPECT_EQ(found.problem, "");
    EXPECT_FALSE(found.links[0]);
  }
}

/// Nobody knows which points are the link's.
TEST(RobotPoints, APoseThatIsNotFiniteIsAProblem) {
  const auto stamp = static_cast<std::int64_t>(ros::Time(kBegin).toNSec());
  for (const bool is_static : {false, true}) {
    for (const std::int64_t length : {0, 10'000'000}) {
      Scanned scanned;
      Body ball;
      ball.shapes.push_back({{nullptr, Solid::kEllipsoid, Eigen::Vector3d(0.1, 0.1, 0.1),
                              Eigen::Affine3d::Identity()}});
      scanned.add("link", ball, {});
      const Eigen::Vector3d far(std::numeric_limits<double>::infinity(), 0, 0);
      for (const double time : {kBegin - 1, kBegin + 1})
        scanned.tf.add({edge("sensor", "link", time, Eigen::Quaterniond::Identity(), far)},
                       is_static, ros::Time(kBegin));
      const ScanPoses poses = scanned.poses({stamp, stamp + length});
      EXPECT_NE(poses.problem, "") << is_static << ' ' << length;
    }
  }
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds of every layout, and those that lie about themselves.
#include "world/cloud/cloud_layout.h"

#include <gtest/gtest.h>

#include <limits>

#include "testing/brute_force.h"
#include "world/cloud/without_points.h"

namespace link_bounds {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::int64_t kStamp = 1700000000000000000;

void addField(PointCloud2& cloud, const std::string& name, std::uint32_t offset,
              std::uint8_t type) {
  cloud.fields.emplace_back();
  cloud.fields.back().name = name;
  cloud.fields.back().offset = offset;
  cloud.fields.back().datatype = type;
  cloud.fields.back().count = 1;
}

/// x, y and z, one after the other.
void addPlaces(PointCloud2& cloud, std::uint8_t type, std::uint32_t bytes) {
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z"}) {
    addField(cloud, name, offset, type);
    offset += bytes;
  }
}

/// z, y, rgb, x, ring and t, in rows with bytes behind them.
PointCloud2 oddCloud(std::uint32_t width, std::uint32_t height) {
  PointCloud2 cloud;
  cloud.header.stamp.fromNSec(kStamp);
  cloud.width = width;
  cloud.height = height;
  cloud.point_step = 26;
  cloud.row_step = width * cloud.point_step + 7;
  addField(cloud, "z", 1, PointField::FLOAT32);
  addField(cloud, "y", 5, PointField::FLOAT32);
  addField(cloud, "rgb", 9, PointField::FLOAT32);
  addField(cloud, "x", 13, PointField::FLOAT32);
  addField(cloud, "ring", 17, PointField::UINT16);
  addField(cloud, "t", 20, PointField::UINT32);
  cloud.data.resize(cloud.row_step * height, 77);
  for (std::uint32_t i = 0; i < width * height; ++i) {
    std::uint8_t* bytes = cloud.data.data() + i / width * cloud.row_step + i % width * 26;
    const float z = static_cast<float>(i), y = z + 0.25f, x = z + 0.5f;
    const std::uint32_t time = 1000 * i;
    std::memcpy(bytes + 1, &z, 4);
    std::memcpy(bytes + 5, &y, 4);
    std::memcpy(bytes + 13, &x, 4);
    std::memcpy(bytes + 20, &time, 4);
  }
  return cloud;
}

TEST(CloudLayout, ReadsFieldsInAnyOrderAndRowsWithBytesBehindThem) {
  const PointCloud2 cloud = oddCloud(3, 4);
  const CloudLayout layout = layoutOf(cloud);
  ASSERT_EQ(layout.problem, "");
  ASSERT_EQ(layout.points.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    const std::uint8_t* bytes = layout.points.point(i);
    const auto number = static_cast<double>(i);
    EXPECT_EQ(layout.points.position(bytes), Eigen::Vector3d(number + 0.5, number + 0.25, number));
    EXPECT_EQ(layout.points.timeOf(bytes), kStamp + 1000 * static_cast<std::int64_t>(i));
  }
  const auto span = timeSpan(layout.points);
  EXPECT_EQ(span->begin, kStamp);
  EXPECT_EQ(span->end, kStamp + 11000);
}

TEST(CloudLayout, RefusesWhatDoesNotFitItsData) {
  const auto problemOf = [](void (*damage)(PointCloud2&)) {
    PointCloud2 cloud = oddCloud(3, 4);
    damage(cloud);
    return layoutOf(cloud).problem;
  };
  const auto has = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.point_step = 20; }), "point_step");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.point_step = 0; }), "point_step");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.point_step = 4000000000u; }), "point_step");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.row_step = 20; }), "row_step");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.data.pop_back(); }), "bytes of data");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.height = 4000000000u; }), "bytes of data");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.data.push_back(0); }), "bytes of data");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.width = 0; }), "bytes of data");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.height = 0; }), "bytes of data");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.is_bigendian = true; }), "big-endian");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.fields[0].name = "a"; }), "no field z");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.fields[0].offset = 4294967295u; }),
               "field z ends");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.fields[0].datatype = PointField::INT16; }),
               "field z has datatype");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.fields[0].datatype = PointField::FLOAT64; }),
               "not all FLOAT32");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.fields[5].datatype = PointField::UINT8; }),
               "field t has datatype");
  EXPECT_PRED2(has, problemOf([](PointCloud2& c) { c.fields[5].offset = 23; }), "field t ends");
}

TEST(CloudLayout, AnEmptyCloudHasNoPoints) {
  for (const bool has_width : {false, true}) {
    PointCloud2 cloud;
    cloud.width = has_width ? 7 : 0;
    const CloudLayout layout = layoutOf(cloud);
    EXPECT_EQ(layout.problem, "");
    EXPECT_EQ(layout.points.size(), 0u);
    EXPECT_FALSE(timeSpan(layout.points));
    removePoints({}, false, cloud);
    EXPECT_EQ(cloud.data.size(), 0u);
  }
}

/// The time of a point whose field has that value.
template <class Number>
std::int64_t timeOf(const char* name, std::uint8_t type, Number value) {
  PointCloud2 cloud = oddCloud(1, 1);
  cloud.fields.pop_back();
  cloud.point_step = 36;
  cloud.row_step = 36;
  cloud.data.resize(36);
  addField(cloud, name, 28, type);
  std::memcpy(cloud.data.data() + 28, &value, sizeof value);
  const CloudLayout layout = layoutOf(cloud);
  EXPECT_EQ(layout.problem, "");
  return layout.points.timeOf(layout.points.point(0)) - kStamp;
}

TEST(CloudLayout, KnowsTheTimesOfCommonDrivers) {
  EXPECT_EQ(timeOf<std::uint32_t>("t", PointField::UINT32, 99000000), 99000000);
  EXPECT_EQ(timeOf<std::uint32_t>("offset_time", PointField::UINT32, 5), 5);
  EXPECT_EQ(timeOf<float>("time", PointField::FLOAT32, -0.0625f), -62500000);
  EXPECT_EQ(timeOf<double>("timestamp", PointField::FLOAT64, 1700000000.0625), 62500000);
  EXPECT_NEAR(static_cast<double>(timeOf<double>("timestamp", PointField::FLOAT64, 1.7e18 + 1e7)),
              1e7, 256);
  EXPECT_EQ(timeOf<std::int32_t>("t", PointField::INT32, -5), -5);
  EXPECT_EQ(timeOf<float>("time", PointField::FLOAT32, kNan), 0);
}

/// One point, whose time is in bytes 16 to 23.
PointCloud2 cloudWithTime(const char* name, std::uint8_t type) {
  PointCloud2 cloud;
  addPlaces(cloud, PointField::FLOAT32, 4);
  addField(cloud, name, 16, type);
  cloud.width = cloud.height = 1;
  cloud.point_step = cloud.row_step = 24;
  cloud.data.resize(24, 0);
  return cloud;
}

TEST(CloudLayout, KnowsTimesThatAreSimulated) {
  PointCloud2 cloud = cloudWithTime("timestamp", PointField::FLOAT64);
  for (const double stamp : {0.5, 9.0, 3600.0, 1e5, 1e6}) {
    cloud.header.stamp = ros::Time(stamp);
    for (const double after : {-0.1, -0.01, 0.0, 0.01, 0.1}) {
      for (const double number : {after, stamp + after, (stamp + after) * 1e9}) {
        std::memcpy(cloud.data.data() + 16, &number, 8);
        const CloudLayout layout = layoutOf(cloud);
        const auto time = static_cast<double>(layout.points.timeOf(layout.points.point(0)));
        EXPECT_NEAR(time * 1e-9 - stamp, after, 1e-6) << stamp << ": " << number;
      }
    }
  }
}

/// A scan of 0.1 s, begun when the clock has just begun.
TEST(CloudLayout, KnowsTimesOfAClockThatHasJustBegun) {
  PointCloud2 relative = cloudWithTime("time", PointField::FLOAT32);
  PointCloud2 absolute = cloudWithTime("timestamp", PointField::FLOAT64);
  for (const double stamp : {0.001, 0.05, 0.1, 0.15, 5.0}) {
    relative.header.stamp = absolute.header.stamp = ros::Time(stamp);
    const auto check = [stamp](const PointCloud2& cloud, double after) {
      const CloudLayout layout = layoutOf(cloud);
      EXPECT_EQ(layout.problem, "");
      const auto time = static_cast<double>(layout.points.timeOf(layout.points.point(0)));
      EXPECT_NEAR(time * 1e-9 - stamp, after, 1e-7) << stamp;
    };
    for (const float after : {-0.001f, 0.02f, 0.06f, 0.1f}) {
      std::memcpy(relative.data.data() + 16, &after, 4);
      check(relative, after);
      if (after < 0) continue;
      const double seconds = stamp + after, nanoseconds = seconds * 1e9;
      for (const double number : {seconds, nanoseconds}) {
        std::memcpy(absolute.data.data() + 16, &number, 8);
        check(absolute, after);
      }
    }
  }
}

/// In the order of doc/clouds.md.
TEST(CloudLayout, TheFirstOfSeveralTimesCounts) {
  PointCloud2 cloud;
  cloud.header.stamp = ros::Time(1);
  addPlaces(cloud, PointField::FLOAT32, 4);
  addField(cloud, "timestamp", 16, PointField::FLOAT64);
  addField(cloud, "time", 24, PointField::FLOAT32);
  addField(cloud, "offset_time", 28, PointField::UINT32);
  cloud.width = cloud.height = 1;
  cloud.point_step = cloud.row_step = 32;
  cloud.data.resize(32, 0);
  const float seconds = 0.5f;
  const std::uint32_t nanoseconds = 7;
  std::memcpy(cloud.data.data() + 24, &seconds, 4);
  std::memcpy(cloud.data.data() + 28, &nanoseconds, 4);
  const CloudLayout layout = layoutOf(cloud);
  EXPECT_EQ(layout.points.timeOf(layout.points.point(0)), 1'000'000'007);
  cloud.fields.pop_back();
  const CloudLayout without = layoutOf(cloud);
  EXPECT_EQ(without.points.timeOf(without.points.point(0)), 1'500'000'000);
}

TEST(CloudLayout, NumbersThatAreNoTimeGiveTheStamp) {
  const double nan = kNan, infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity})
    EXPECT_EQ(timeOf<double>("timestamp", PointField::FLOAT64, bad), 0) << bad;
  // As of a clock that was not set: nobody takes these for times at the stamp.
  for (const double bad : {1e300, -1e300, 1e19, -1e18, -1.7e9, 9e9 + 1.0, 1e13, 8e8, 9e8})
    EXPECT_GT(std::abs(timeOf<double>("timestamp", PointField::FLOAT64, bad)),
              100'000'000'000'000'000)
        << bad;
  // The latest and the earliest time that there is are not too far apart for 64 bits.
  PointCloud2 cloud;
  cloud.header.stamp = ros::Time(1);
  addPlaces(cloud, PointField::FLOAT64, 8);
  addField(cloud, "timestamp", 24, PointField::FLOAT64);
  cloud.width = 2;
  cloud.height = 1;
  cloud.point_step = 32;
  cloud.row_step = 64;
  cloud.data.resize(64, 0);
  const double first = -1e7, last = 8.9e18;
  std::memcpy(cloud.data.data() + 24, &first, 8);
  std::memcpy(cloud.data.data() + 56, &last, 8);
  const auto span = timeSpan(layoutOf(cloud).points);
  EXPECT_GT(span->end - span->begin, 0);
}

TEST(CloudLayout, PointsThatAreNotFiniteHaveNoTime) {
  PointCloud2 cloud = oddCloud(2, 1);
  std::memcpy(cloud.data.data() + 26 + 5, &kNan, 4);
  const auto span = timeSpan(layoutOf(cloud).points);
  EXPECT_EQ(span->begin, kStamp);
  EXPECT_EQ(span->end, kStamp);
}

TEST(RemovePoints, KeepsAllFieldsAndTheHeader) {
  const PointCloud2 cloud = oddCloud(3, 2);
  PointCloud2 organised = cloud, compact = cloud;
  removePoints({{1, 0}, {5, 0}}, true, organised);
  removePoints({{1, 0}, {5, 0}}, false, compact);
  EXPECT_EQ(organised.header, cloud.header);
  EXPECT_EQ(organised.width, 3u);
  EXPECT_FALSE(organised.is_dense);
  const CloudLayout before = layoutOf(cloud), after = layoutOf(organised);
  for (std::size_t i = 0; i < 6; ++i) {
    const bool is_removed = i == 1 || i == 5;
    const Eigen::Vector3d place = after.points.position(after.points.point(i));
    EXPECT_EQ(place.array().isNaN().all(), is_removed) << i;
    EXPECT_EQ(std::memcmp(before.points.point(i) + 17, after.points.point(i) + 17, 9), 0);
    if (is_removed) continue;
    EXPECT_EQ(std::memcmp(before.points.point(i), after.points.point(i), 26), 0);
  }
  EXPECT_EQ(compact.width, 4u);
  EXPECT_EQ(compact.height, 1u);
  const CloudLayout rest = layoutOf(compact);
  ASSERT_EQ(rest.problem, "");
  const std::size_t kept[] = {0, 2, 3, 4};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(std::memcmp(rest.points.point(i), before.points.point(kept[i]), 26), 0);
  const PointCloud2 only = onlyPoints({{1, 0}, {5, 0}}, cloud);
  EXPECT_EQ(only.width, 2u);
  EXPECT_EQ(std::memcmp(only.data.data() + 26, before.points.point(5), 26), 0);
}

TEST(LaserPoints, LieWhereTheRangesWereMeasured) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp.fromNSec(kStamp);
  scan.angle_increment = static_cast<float>(M_PI / 2);
  scan.time_increment = 0.125f;
  scan.range_min = 0.5f;
  scan.range_max = 10;
  scan.ranges = {1, 2, 0.25f, kNan, 20};
  const LaserPoints laser(scan);
  ASSERT_EQ(problemOf(scan), "");
  const CloudPoints& points = laser.points();
  ASSERT_EQ(points.size(), 5u);
  EXPECT_LT((points.position(points.point(1)) - Eigen::Vector3d(0, 2, 0)).norm(), 1e-6);
  for (const std::size_t bad : {2u, 3u, 4u})
    EXPECT_FALSE(points.position(points.point(bad)).allFinite()) << bad;
  EXPECT_EQ(timeSpan(points)->end, kStamp + 125000000);
  removePoints({{1, 0}}, scan);
  EXPECT_TRUE(std::isnan(scan.ranges[1]));
  scan.header.stamp.fromNSec(1'000'000);  // simulated time has just begun
  const LaserPoints early(scan);
  EXPECT_EQ(early.points().timeOf(early.points().point(0)), 1'000'000);
  EXPECT_EQ(early.points().timeOf(early.points().point(1)), 126'000'000);
  scan.time_increment = 1e30f;
  const LaserPoints absurd(scan);
  EXPECT_EQ(absurd.points().timeOf(absurd.points().point(1)),
            1'000'000'000'001'000'000);  // 1e9 s after the stamp
  EXPECT_EQ(scan.ranges[0], 1);
  scan.angle_increment = kNan;
  EXPECT_NE(problemOf(scan), "");
}

}  // namespace
}  // namespace link_bounds

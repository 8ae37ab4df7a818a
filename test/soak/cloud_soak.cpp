// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sends clouds of 640 x 480 at 30 Hz to cloud_filter, beside tf of a moving robot at 100 Hz, and
// checks that each comes back and that the filter's memory does not grow. Where a cloud was lost,
// it says: before the filter, in it and why, or after it.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "joint_motion.h"
#include "soak_program.h"
#include "testing/process_census.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr double kCloudRate = 30, kTfRate = 100;  // Hz
constexpr std::uint32_t kQueue = 100;  // clouds; a sender or reader that waits loses none
constexpr int kBurst = 5;              // clouds at once
constexpr double kMinute = 60;         // s; memory counts from the end of the first one

/// In the frame of the robot's root link: a wall beside the robot, and in each tenth row a sheet
/// that waves through it.
sensor_msgs::PointCloud2 cloudAround(const std::string& frame) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = frame;
  cloud.width = kWidth;
  cloud.height = kHeight;
  cloud.is_dense = true;
  cloud.point_step = 16;
  cloud.row_step = kWidth * cloud.point_step;
  for (std::uint32_t k = 0; k < 3; ++k) {
    sensor_msgs::PointField& field = cloud.fields.emplace_back();
    field.name = std::string(1, "xyz"[k]);
    field.offset = 4 * k;
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
  }
  cloud.data.resize(std::size_t{cloud.row_step} * kHeight);
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) {
      const float place[3] = {
          3.0f * static_cast<float>(u) / kWidth - 1.5f,
          v % 10 != 0 ? 1.5f : 0.3f * std::sin(0.05f * static_cast<float>(u + 2 * v)),
          1.6f * static_cast<float>(v) / kHeight};
      std::memcpy(cloud.data.data() + v * cloud.row_step + u * cloud.point_step, place, 12);
    }
  }
  return cloud;
}

/// Counts what comes back, and how long that took.
class Returned {
 public:
  explicit Returned(ros::NodeHandle& node)
      : subscriber_(node.subscribe("/cloud_filter/output", kQueue, &Returned::take, this)) {}

  int count() const { return count_; }
  bool hasRobotPoints() const { return has_robot_points_; }

  /// Sorted [ms]; only after the last message.
  std::vector<double> delays() const {
    std::vector<double> sorted = delays_;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

 private:
  void take(const sensor_msgs::PointCloud2& cloud) {
    delays_.push_back((ros::Time::now() - cloud.header.stamp).toSec() * 1e3);
    if (!cloud.is_dense) has_robot_points_ = true;
    ++count_;
  }

  std::atomic<int> count_{0};
  std::atomic<bool> has_robot_points_{false};
  std::vector<double> delays_;
  ros::Subscriber subscriber_;
};

/// What the filter says of itself.
class FilterReport {
 public:
  explicit FilterReport(ros::NodeHandle& node)
      : subscriber_(node.subscribe("/diagnostics", 10, &FilterReport::take, this)) {}

  int filtered() const { return filtered_; }
  int dropped() const { return dropped_; }

  /// How often it said why.
  std::map<std::string, int> reasons() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reasons_;
  }

 private:
  void take(const diagnostic_msgs::DiagnosticArray& message) {
    const std::string why = "not filtered: ";
    for (const auto& status : message.status) {
      if (status.name != "/cloud_filter: cloud filter") continue;
      for (const auto& value : status.values) {
        const int number = std::atoi(value.value.c_str());
        if (value.key == "filtered") filtered_ = number;
        if (value.key == "dropped") dropped_ = number;
        if (value.key.rfind(why, 0) != 0) continue;
        const std::lock_guard<std::mutex> lock(mutex_);
        const std::string reason = value.key.substr(why.size());
        reasons_[reason.substr(0, reason.find(" from "))] += number;  // without stamps
      }
    }
  }

  std::atomic<int> filtered_{0}, dropped_{0};
  mutable std::mutex mutex_;
  std::map<std::string, int> reasons_;
  ros::Subscriber subscriber_;
};

class CloudSoak {
 public:
  CloudSoak(ros::NodeHandle& node, const Robot& robot)
      : robot_(robot),
        tf_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
        tf_static_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true)),
        clouds_(node.advertise<sensor_msgs::PointCloud2>("/cloud", kQueue)),
        returned_(node),
        report_(node),
        cloud_(cloudAround(robot.links[robot.root].name)) {
    tf_static_.publish(fixedTransforms(robot));
  }

  /// Until the filter has loaded the robot and answers.
  void waitForFilter() {
    ros::SteadyTime next_cloud;
    waitFor(
        [&] {
          sendTf();
          const ros::SteadyTime now = ros::SteadyTime::now();
          if (clouds_.getNumSubscribers() > 0 && now >= next_cloud) {
            sendCloud();
            next_cloud = now + ros::WallDuration(0.5);
          }
          return returned_.count() > 0;
        },
        "the first cloud comes back");
    ros::WallDuration(1).sleep();
  }

  /// The C library keeps the memory of as many clouds as once waited together, so let some wait
  /// before memory counts.
  void sendBurst() {
    const int wanted = returned_.count() + kBurst;
    for (int i = 0; i < kBurst; ++i)
      sendCloud();
    waitFor(
        [&] {
          sendTf();
          return returned_.count() >= wanted;
        },
        "a burst of clouds comes back");
  }

  bool run(const SoakArguments& arguments) {
    const int sent_before = sent_, returned_before = returned_.count();
    const ros::SteadyTime begin = ros::SteadyTime::now();
    double first = 0, largest = 0, next_cloud = 0;
    int minutes = 0;
    ros::WallRate rate(kTfRate);
    for (double now = 0; ros::ok() && minutes < arguments.minutes;
         now = (ros::SteadyTime::now() - begin).toSec()) {
      sendTf();
      if (now >= next_cloud) {
        sendCloud();
        next_cloud =
            std::max(next_cloud + 1 / kCloudRate, now);  // as cameras, which catch up nothing
      }
      if (now >= kMinute * (minutes + 1)) {
        const auto memory = static_cast<double>(residentBytes(arguments.pid));
        if (first == 0) first = memory;
        largest = std::max(largest, memory);
        std::printf("%3.0f s: %d clouds sent, %d came back, %.1f MB\n", now, sent_ - sent_before,
                    returned_.count() - returned_before, memory / 1e6);
        std::fflush(stdout);
        ++minutes;
      }
      rate.sleep();
    }
    for (int i = 0; i < 100 && (returned_.count() - returned_before < sent_ - sent_before ||
                                report_.filtered() + report_.dropped() < sent_);
         ++i) {
      sendTf();
      ros::WallDuration(0.05).sleep();
    }
    const int lost = (sent_ - sent_before) - (returned_.count() - returned_before);
    const double growth = largest - first;
    const std::vector<double> delays = returned_.delays();
    const bool is_good = minutes == arguments.minutes && lost == 0 &&
                         growth < arguments.max_growth && returned_.hasRobotPoints();
    std::printf("%s: %d of %d clouds lost (allowed: 0), points of the robot %s\n",
                is_good ? "passed" : "FAILED", lost, sent_ - sent_before,
                returned_.hasRobotPoints() ? "removed" : "NOT removed");
    if (minutes < 2) {
      std::printf("  %s\n", kNoGrowth);
    } else {
      std::printf("  memory %+.1f MB after the first minute (allowed: < %.1f)\n", growth / 1e6,
                  arguments.max_growth / 1e6);
    }
    std::printf("  from stamp to output: median %.1f ms, 99 %% %.1f ms, max %.1f ms\n",
                delays[delays.size() / 2], delays[delays.size() * 99 / 100], delays.back());
    printLosses();
    return is_good;
  }

 private:
  /// Since the start, so with those that came before the robot was loaded.
  void printLosses() const {
    std::printf(
        "  of all %d clouds, %d were lost before the filter, %d dropped by it, %d lost after it\n",
        sent_, sent_ - report_.filtered() - report_.dropped(), report_.dropped(),
        report_.filtered() - returned_.count());
    for (const auto& [reason, count] : report_.reasons())
      std::printf("  dropped, because %s: %d\n", reason.c_str(), count);
  }

  void sendTf() { tf_.publish(movingTransforms(robot_, ros::Time::now())); }

  void sendCloud() {
    cloud_.header.stamp = ros::Time::now();
    clouds_.publish(cloud_);
    ++sent_;
  }

  const Robot& robot_;
  ros::Publisher tf_, tf_static_, clouds_;
  Returned returned_;
  FilterReport report_;
  sensor_msgs::PointCloud2 cloud_;
  int sent_ = 0;
};

bool soak(const SoakArguments& arguments) {
  ros::NodeHandle node;
  const Robot robot = describedRobot(node);
  CloudSoak soak(node, robot);
  soak.waitForFilter();
  soak.sendBurst();
  return soak.run(arguments);
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  return link_bounds::runSoak(argc, argv, "cloud_soak", link_bounds::soak);
}

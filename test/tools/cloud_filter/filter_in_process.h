// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A filter that runs in the process of a test, so that a listener of its log can hold it up.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/console.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "testing/own_master.h"
#include "testing/patience.h"
#include "tools/cloud_filter/cloud_filter_node.h"

namespace link_bounds {

/// Small, because its grid takes minutes under a sanitizer where it is a metre wide.
constexpr char kCubeRobot[] = R"(<robot name="cube"><link name="cube"><visual><geometry>
  <box size="0.02 0.02 0.02"/></geometry></visual></link></robot>)";

/// Of a status; that of one second later has it no more.
constexpr char kTooMany[] = "not filtered: more clouds came than could be filtered";

/// Who logs that a cloud was dropped waits here until this is open.
class LogGate : public ros::console::LogAppender {
 public:
  LogGate() { ros::console::register_appender(this); }
  ~LogGate() override {
    open();
    ros::console::deregister_appender(this);
  }

  void log(ros::console::Level, const char* text, const char*, const char*, int) override {
    if (std::string(text).find("was dropped") == std::string::npos) return;
    std::unique_lock<std::mutex> lock(mutex_);
    is_reached_ = true;
    opened_.wait(lock, [this] { return is_open_; });
  }

  bool isReached() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_reached_;
  }

  void open() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = true;
    opened_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable opened_;
  bool is_reached_ = false;
  bool is_open_ = false;
};

/// One per process, because a process has one master.
class FilterInProcess : public testing::Test {
 protected:
  /// `simulated`: the time that it begins with; 0: it does not use simulated time.
  explicit FilterInProcess(double max_wait = 0, const std::string& late = "drop",
                           double simulated = 0) {
    if (simulated > 0) ros::Time::setNow(ros::Time(simulated));
    ros::param::set("/robot_description", kCubeRobot);
    ros::param::set("~max_wait", max_wait);
    ros::param::set("~late", late);
    filter_ = std::make_unique<CloudFilterNode>(node_, ros::NodeHandle("~"), [] {});
    // Later than the filter's subscription, so the filter has what came here.
    witness_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/filter_in_process/input", 100,
        [this](const sensor_msgs::PointCloud2ConstPtr&) { ++heard_; });
    status_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          if (values_.count(kTooMany) > 0) return;
          values_.clear();
          for (const diagnostic_msgs::KeyValue& value : array->status.front().values)
            values_[value.key] = value.value;
          message_ = array->status.front().message;
        });
    clouds_ = node_.advertise<sensor_msgs::PointCloud2>("/filter_in_process/input", 100);
    scans_ = node_.advertise<sensor_msgs::LaserScan>("/filter_in_process/input_scan", 100);
    thread_ = std::thread([this] { filter_->spin(); });
  }
  ~FilterInProcess() override {
    gate_.open();
    filter_->stop();
    thread_.join();
  }

  /// Points at the origin. By default, of a frame that tf does not know.
  void send(const std::string& frame = "nowhere", ros::Time stamp = ros::Time(1),
            std::uint32_t points = 1) {
    sensor_msgs::PointCloud2 cloud;
    cloud.header.stamp = stamp;
    cloud.header.frame_id = frame;
    for (const char* const name : {"x", "y", "z"}) {
      sensor_msgs::PointField& field = cloud.fields.emplace_back();
      field.name = name;
      field.offset = cloud.point_step;
      field.datatype = sensor_msgs::PointField::FLOAT32;
      field.count = 1;
      cloud.point_step += 4;
    }
    cloud.height = 1;
    cloud.width = points;
    cloud.row_step = points * cloud.point_step;
    cloud.data.resize(cloud.row_step);
    clouds_.publish(cloud);
    ++sent_;
  }

  OwnMaster master_{"filter_in_process"};
  ros::NodeHandle node_;
  LogGate gate_;
  std::unique_ptr<CloudFilterNode> filter_;
  ros::Publisher clouds_, scans_;
  ros::Subscriber witness_, status_;
  std::map<std::string, std::string> values_;
  std::string message_;
  std::size_t sent_ = 0, heard_ = 0;
  std::thread thread_;
};

}  // namespace link_bounds

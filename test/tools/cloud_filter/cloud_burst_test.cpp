// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// More clouds than may wait come while the filter is busy. It runs in this process, so that a
// listener of its log can hold it up.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/console.h>
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
namespace {

constexpr char kRobot[] = R"(<robot name="cube"><link name="cube"><visual><geometry>
  <box size="1 1 1"/></geometry></visual></link></robot>)";

/// Of a status; that of one second later has it no more.
constexpr char kReason[] = "not filtered: more clouds came than could be filtered";

/// Who logs that a cloud was dropped waits here until this is open.
class Gate : public ros::console::LogAppender {
 public:
  Gate() { ros::console::register_appender(this); }
  ~Gate() override {
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

class CloudBurst : public testing::Test {
 protected:
  CloudBurst() {
    ros::param::set("/robot_description", kRobot);
    ros::param::set("~max_wait", 0.0);
    filter_ = std::make_unique<CloudFilterNode>(node_, ros::NodeHandle("~"), [] {});
    // Later than the filter's subscription, so the filter has what came here.
    witness_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/cloud_burst_test/input", 100,
        [this](const sensor_msgs::PointCloud2ConstPtr&) { ++heard_; });
    status_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          if (values_.count(kReason) > 0) return;
          values_.clear();
          for (const diagnostic_msgs::KeyValue& value : array->status.front().values)
            values_[value.key] = value.value;
          message_ = array->status.front().message;
        });
    clouds_ = node_.advertise<sensor_msgs::PointCloud2>("/cloud_burst_test/input", 100);
    thread_ = std::thread([this] { filter_->spin(); });
  }
  ~CloudBurst() override {
    gate_.open();
    filter_->stop();
    thread_.join();
  }

  template <class Condition>
  static bool isServed(const Condition& condition) {
    return becomesTrue([&] {
      ros::spinOnce();
      return condition();
    });
  }

  /// A cloud of a frame that tf does not know.
  void send() {
    sensor_msgs::PointCloud2 cloud;
    cloud.header.stamp = ros::Time(1);
    cloud.header.frame_id = "nowhere";
    for (const char* const name : {"x", "y", "z"}) {
      sensor_msgs::PointField& field = cloud.fields.emplace_back();
      field.name = name;
      field.offset = cloud.point_step;
      field.datatype = sensor_msgs::PointField::FLOAT32;
      field.count = 1;
      cloud.point_step += 4;
    }
    cloud.height = cloud.width = 1;
    cloud.row_step = cloud.point_step;
    cloud.data.resize(cloud.row_step);
    clouds_.publish(cloud);
    ++sent_;
  }

  OwnMaster master_{"cloud_burst_test"};
  ros::NodeHandle node_;
  Gate gate_;
  std::unique_ptr<CloudFilterNode> filter_;
  ros::Publisher clouds_;
  ros::Subscriber witness_, status_;
  std::map<std::string, std::string> values_;
  std::string message_;
  std::size_t sent_ = 0, heard_ = 0;
  std::thread thread_;
};

TEST_F(CloudBurst, WhatCannotWaitIsNotLateIfNothingWaitedBefore) {
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  send();
  ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it is late, and the last one";
  for (std::uint32_t i = 0; i < FilterHealth::kQueue; ++i)
    send();
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  gate_.open();
  ASSERT_TRUE(isServed([&] { return values_.count(kReason) > 0; }));
  EXPECT_EQ(values_[kReason], "1");
  EXPECT_EQ(values_["times that a queue of clouds was full"], "1");
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A filter in the process of a test that tells it the time, and where its cube is.
#pragma once

#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "testing/live_boxes_testing.h"
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {

/// Each message is with the filter before the next one is sent, so all come in the order of the
/// test.
class SimulatedFilter : public FilterInProcess {
 protected:
  SimulatedFilter() : FilterInProcess(10, "drop", kBegin) {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 100);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    // Later than those of the filter, as the witness of clouds.
    clock_witness_ = node_.subscribe<rosgraph_msgs::Clock>(
        "/clock", 100, [this](const rosgraph_msgs::ClockConstPtr&) { ++told_; });
    tf_witness_ = node_.subscribe<tf2_msgs::TFMessage>(
        "/tf", 100, [this](const tf2_msgs::TFMessageConstPtr&) { ++told_; });
  }

  static constexpr double kBegin = 1000;  // s

  void tellTime(double seconds) {
    ros::Time::setNow(ros::Time(seconds));
    rosgraph_msgs::Clock clock;
    clock.clock = ros::Time(seconds);
    publish(clock_, clock);
  }

  /// The cube is so far from the sensor at that time.
  void tell(double seconds, double x) {
    tellTime(seconds);
    tf2_msgs::TFMessage message;
    message.transforms = {
        edge("sensor", "cube", seconds, Eigen::Quaterniond::Identity(), {x, 0, 0})};
    publish(tf_, message);
  }

  template <class Message>
  void publish(const ros::Publisher& publisher, const Message& message) {
    const std::size_t before = told_;
    publisher.publish(message);
    ASSERT_TRUE(isServed([&] { return told_ > before; }));
  }

  void sendCloud(ros::Time stamp, std::uint32_t points = 1) {
    send("sensor", stamp, points);
    ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  }

  /// Holds the filter up: it waits where it logs that this cloud is dropped.
  void holdUp() {
    ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
    tell(kBegin, 1);
    sendCloud(ros::Time());
    ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it has no stamp";
  }

  ros::Publisher clock_, tf_;
  ros::Subscriber clock_witness_, tf_witness_;
  std::size_t told_ = 0;
};

}  // namespace link_bounds

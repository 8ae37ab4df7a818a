// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulated time jumps back while the filter is busy: what is of the old time gets no pose of the
// new one, and what is of the new time none of the old one.
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

#include "testing/live_boxes_testing.h"
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

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

  void sendCloud(ros::Time stamp) {
    send("sensor", stamp);
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

TEST_F(SimulatedFilter, MixesNoTimes) {
  holdUp();
  for (int i = 1; i <= 5; ++i)
    tell(kBegin + i, 1);
  sendCloud(ros::Time(kBegin + 5.5));  // tf of that time never comes
  tell(kBegin, 0);
  sendCloud(ros::Time(kBegin + 5.2));  // is late, too
  for (int i = 1; i <= 10; ++i)
    tell(kBegin + i, 0);
  sendCloud(ros::Time(kBegin + 3));  // where the cube is at the sensor
  for (std::uint32_t i = 0; i < TfReceiver::kQueue; ++i)
    tellTime(kBegin + 10);
  gate_.open();
  std::string robot_points;
  ASSERT_TRUE(isServed([&] {
    if (values_["robot points [%]"] != "0.00") robot_points = values_["robot points [%]"];
    EXPECT_EQ(message_.find("transforms may have been lost"), std::string::npos) << "all came";
    return values_["filtered"] == "1" && values_["dropped"] == "3";
  })) << values_["filtered"]
      << " filtered, " << values_["dropped"] << " dropped";
  EXPECT_EQ(robot_points, "100.00");
}

}  // namespace
}  // namespace link_bounds

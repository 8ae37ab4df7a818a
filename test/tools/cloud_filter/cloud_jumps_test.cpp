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

/// The filter hears the clock only from here, so all comes to it in the order of the test.
class SimulatedFilter : public FilterInProcess {
 protected:
  SimulatedFilter() : FilterInProcess(60, "drop", kBegin) {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 100);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  }

  static constexpr double kBegin = 1000;  // s

  /// The cube is so far from the sensor at that time.
  void tell(double seconds, double x) {
    ros::Time::setNow(ros::Time(seconds));
    rosgraph_msgs::Clock clock;
    clock.clock = ros::Time(seconds);
    clock_.publish(clock);
    tf2_msgs::TFMessage message;
    message.transforms = {
        edge("sensor", "cube", seconds, Eigen::Quaterniond::Identity(), {x, 0, 0})};
    tf_.publish(message);
  }

  /// Holds the filter up: it waits where it logs that this cloud is dropped.
  void holdUp() {
    ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
    ASSERT_TRUE(isServed([this] { return clock_.getNumSubscribers() > 0; }));
    tell(kBegin, 1);
    send("sensor", ros::Time());
    ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it has no stamp";
  }

  ros::Publisher clock_, tf_;
};

TEST_F(SimulatedFilter, MixesNoTimes) {
  holdUp();
  for (int i = 1; i <= 5; ++i)
    tell(kBegin + i, 1);
  send("sensor", ros::Time(kBegin + 5.5));  // tf of that time never comes
  tell(kBegin, 0);
  send("sensor", ros::Time(kBegin + 5.2));  // is late, too
  for (int i = 1; i <= 10; ++i)
    tell(kBegin + i, 0);
  send("sensor", ros::Time(kBegin + 3));  // where the cube is at the sensor
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  gate_.open();
  std::string robot_points;
  ASSERT_TRUE(isServed([&] {
    if (values_["robot points [%]"] != "0.00") robot_points = values_["robot points [%]"];
    return values_["filtered"] == "1" && values_["dropped"] == "3";
  })) << values_["filtered"]
      << " filtered, " << values_["dropped"] << " dropped";
  EXPECT_EQ(robot_points, "100.00");
}

}  // namespace
}  // namespace link_bounds

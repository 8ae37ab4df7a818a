// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// After a jump stamps lie between those before, so that each is used once.
#include "node/load/storm_sender.h"

#include <rosgraph_msgs/Clock.h>

#include "node/load/swinging_links.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kUnlimited = 0;
constexpr double kPhasePerStep = 0.02;  // rad
const ros::Duration kJump(10.0 - 1e-5);

}  // namespace

StormSender::StormSender(ros::NodeHandle& node, std::size_t links, Ages& ages)
    : links_(links),
      ages_(ages),
      clock_publisher_(node.advertise<rosgraph_msgs::Clock>("/clock", 10, true)),
      tf_publisher_(node.advertise<tf2_msgs::TFMessage>("/tf", kUnlimited)) {
  publishClock();
}

bool StormSender::hasSubscriber() const {
  return clock_publisher_.getNumSubscribers() > 0 && tf_publisher_.getNumSubscribers() > 0;
}

ros::Time StormSender::step() {
  now_ += ros::Duration(kStormPeriod);
  publishClock();
  const tf2_msgs::TFMessage message =
      swingingLinks(links_, kPhasePerStep * static_cast<double>(++steps_), now_);
  ages_.send(now_);
  tf_publisher_.publish(message);
  return now_;
}

void StormSender::jumpBack() {
  now_ -= kJump;
  ++jumps_;
  publishClock();
}

void StormSender::publishClock() {
  rosgraph_msgs::Clock clock;
  clock.clock = now_;
  clock_publisher_.publish(clock);
}

}  // namespace link_bounds

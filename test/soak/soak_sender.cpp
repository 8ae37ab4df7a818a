// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "soak_sender.h"

#include <rosgraph_msgs/Clock.h>

#include <chrono>

#include "joint_motion.h"

namespace link_bounds {
namespace {

constexpr std::chrono::milliseconds kPeriod(1);
constexpr std::uint64_t kStepsPerClock = 10;
constexpr std::uint64_t kStepsPerJump = 20000;
const ros::Duration kJump(10.0);
constexpr std::uint32_t kQueue = 100000;  // large, so that this side loses nothing

}  // namespace

SoakSender::SoakSender(ros::NodeHandle& node, const Robot& robot)
    : robot_(robot),
      clock_publisher_(node.advertise<rosgraph_msgs::Clock>("/clock", 10, true)),
      tf_publisher_(node.advertise<tf2_msgs::TFMessage>("/tf", kQueue)),
      tf_static_publisher_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true)) {
  publishClock();
  tf_static_publisher_.publish(fixedTransforms(robot_));
}

bool SoakSender::hasSubscriber() const {
  return clock_publisher_.getNumSubscribers() > 0 && tf_publisher_.getNumSubscribers() > 0 &&
         tf_static_publisher_.getNumSubscribers() > 0;
}

void SoakSender::start() {
  steps_.emplace(kPeriod, [this] { step(); });
}

void SoakSender::step() {
  now_ += ros::Duration(std::chrono::duration<double>(kPeriod).count());
  if (sent_ % kStepsPerJump == kStepsPerJump - 1) {
    now_ -= kJump;
    ++jumps_;
    publishClock();
  }
  if (sent_ % kStepsPerClock == 0) publishClock();
  tf_publisher_.publish(movingTransforms(robot_, now_));
  ++sent_;
}

void SoakSender::publishClock() {
  rosgraph_msgs::Clock clock;
  clock.clock = now_;
  clock_publisher_.publish(clock);
}

}  // namespace link_bounds

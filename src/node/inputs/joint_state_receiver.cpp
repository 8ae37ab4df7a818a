// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages wait in queue_ until read() handles them.
#include "node/inputs/joint_state_receiver.h"

#include <ros/console.h>

#include <algorithm>
#include <string>

#include "node/interface/topics.h"
#include "world/log/log_text.h"
#include "world/tf/edge_history.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kJointQueue = 1000;  // messages: one second at 1 kHz

}  // namespace

JointStateReceiver::JointStateReceiver() {
  node_.setCallbackQueue(&queue_);
}

const JointStates& JointStateReceiver::read(std::uint64_t epoch) {
  if (!subscriber_) {
    subscriber_ = subscribeReceived<sensor_msgs::JointState>(
        node_, kJointStatesTopic.name, kJointQueue, [this](const Event& event) { take(event); });
  }
  clock_.observe(ros::Time::now());
  queue_.callAvailable();
  states_.observeEpoch(epoch);
  return states_;
}

void JointStateReceiver::rest() {
  subscriber_.shutdown();
  states_.clear();
}

/// Adds positions, and velocities if the message has one for each name.
void JointStateReceiver::take(const Event& event) {
  const auto& message = *event.getConstMessage();
  if (!incomplete_messages_.accept(message, kJointStatesTopic.name, event.getPublisherName()))
    return;
  const auto stamp = nanosecondsOf(message.header.stamp);
  const ros::Time ros_now = ros::Time::now();
  if (clock_.isFromBeforeJump(message.header.stamp, ros_now, ros::SteadyTime::now())) return;
  const auto now = nanosecondsOf(ros_now);
  if (now > 0 && stamp - now > EdgeHistory::kLength) {
    const std::string line =
        ahead_log_.line("messages on " + std::string(kJointStatesTopic.name) + " from \"" +
                            event.getPublisherName() + "\" are ignored: their stamps are " +
                            std::to_string((stamp - now) / 1'000'000'000) +
                            " s ahead of the clock; synchronise the clocks",
                        ros::SteadyTime::now());
    if (!line.empty()) ROS_WARN("%s", logText(line).c_str());
    return;
  }
  const bool have_velocities = message.velocity.size() == message.name.size();
  for (std::size_t i = 0; i < std::min(message.name.size(), message.position.size()); ++i) {
    JointReport report{stamp, message.position[i], {}};
    if (have_velocities) report.velocity = message.velocity[i];
    states_.add(message.name[i], report);
  }
}

}  // namespace link_bounds

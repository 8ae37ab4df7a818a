// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Subscribes to joint_states while an output needs it.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include "node/inputs/incomplete_messages.h"
#include "world/log/repeat_log.h"
#include "world/stopping/joint_states.h"
#include "world/tf/clock_watch.h"

namespace link_bounds {

/// For one thread, which handles the waiting messages when it calls read().
class JointStateReceiver {
 public:
  JointStateReceiver();
  JointStateReceiver(const JointStateReceiver&) = delete;
  JointStateReceiver& operator=(const JointStateReceiver&) = delete;

  /// The joint states received since the subscription, which the first call makes. `epoch` is that
  /// of tf: if it has changed since the last call, the clock has jumped back, and all states are
  /// discarded. Messages with stamps more than ten seconds ahead of the clock are ignored, because
  /// later messages would then count as old. Messages sent before a jump are ignored as well; see
  /// ClockWatch::isFromBeforeJump.
  const JointStates& read(std::uint64_t epoch);

  /// Unsubscribes and discards all states, until the next read().
  void rest();

 private:
  using Event = ros::MessageEvent<Received<sensor_msgs::JointState>>;

  void take(const Event& event);

  ros::CallbackQueue queue_;  ///< declared before the subscriber, which posts into it
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  IncompleteMessages incomplete_messages_;
  RepeatLog ahead_log_;
  ClockWatch clock_;
  JointStates states_;
};

}  // namespace link_bounds

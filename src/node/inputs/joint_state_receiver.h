// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Subscribes to joint_states while somebody needs it.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include "node/inputs/incomplete_messages.h"
#include "world/log/repeat_log.h"
#include "world/stopping/joint_states.h"
#include "world/tf/clock_watch.h"

namespace link_bounds {

/// Of one thread, which reads what has come when it needs it.
class JointStateReceiver {
 public:
  JointStateReceiver();
  JointStateReceiver(const JointStateReceiver&) = delete;
  JointStateReceiver& operator=(const JointStateReceiver&) = delete;

  /// All that has come since the topic is subscribed to, which the first call does. If `epoch`,
  /// that of tf, has changed since the last call, the clock has jumped back, and all is forgotten.
  /// Stamps more than ten seconds ahead of the clock are ignored: others would count as old. What
  /// was sent before a jump is ignored, too; see ClockWatch::isFromBeforeJump.
  const JointStates& read(std::uint64_t epoch);

  /// Forgets all, until the next read().
  void rest();

 private:
  using Event = ros::MessageEvent<Received<sensor_msgs::JointState>>;

  void take(const Event& event);

  ros::CallbackQueue queue_;  ///< before the subscriber, which calls back into it
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  IncompleteMessages incomplete_messages_;
  RepeatLog ahead_log_;
  ClockWatch clock_;
  JointStates states_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the topics /tf and /tf_static into a TransformBuffer.
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>

#include <functional>

#include "node/clock/clock_watch.h"
#include "node/log/refusal_log.h"
#include "node/names/topics.h"
#include "node/tf/tf_message.h"
#include "node/tf/transform_buffer.h"

namespace link_bounds {

/// Not copyable, because roscpp writes messages into its memory.
class TfReceiver {
 public:
  using Event = ros::MessageEvent<const TfMessage>;
  using Callback = std::function<void(const Event& event, bool is_static)>;

  /// `on_message` is called for each message and must pass it to add().
  TfReceiver(ros::NodeHandle& node, const Callback& on_message);
  TfReceiver(const TfReceiver&) = delete;
  TfReceiver& operator=(const TfReceiver&) = delete;

  /// Adds the transforms of a message that arrived at `now`, without those that were sent before
  /// the clock jumped back. Logs what tf refuses.
  void add(const Event& event, bool is_static, const ClockWatch& clock, ros::Time now,
           TransformBuffer& tf);

  /// To be called regularly: frees the memory that only a huge message needs.
  void freeSpareMemory();

  /// What was logged may be logged again.
  void forgetLog() { log_.forget(); }

 private:
  ros::Subscriber subscribe(ros::NodeHandle& node, const TopicName& topic, bool is_static,
                            const Callback& on_message);
  void addAll(const std::vector<TransformView>& transforms, bool is_static, ros::Time now,
              const Event& event, TransformBuffer& tf);

  RefusalLog log_{"a transform of", "transforms of further frames"};
  TfMessageMemory memory_;
  TfMessageMemory static_memory_;
  ros::Subscriber subscriber_;
  ros::Subscriber static_subscriber_;
};

}  // namespace link_bounds

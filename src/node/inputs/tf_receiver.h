// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Subscribes to /tf and /tf_static.
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <memory>

#include "node/interface/topics.h"
#include "world/tf/tf_message.h"

namespace link_bounds {

class TfReceiver {
 public:
  using Event = ros::MessageEvent<const TfMessage>;
  using Callback = std::function<void(const Event& event, bool is_static)>;

  /// Max waiting messages of /tf: one second at 1 kHz; tf2_ros has 100. If more come, roscpp drops
  /// the oldest without notice.
  static constexpr std::uint32_t kQueue = 1000;

  /// `on_message` is called for each message.
  TfReceiver(ros::NodeHandle& node, const Callback& on_message);
  TfReceiver(const TfReceiver&) = delete;
  TfReceiver& operator=(const TfReceiver&) = delete;

  /// While set, messages of /tf are not deserialised; their callbacks get an empty message with
  /// is_skipped set.
  void skip(bool skips) { memory_->skip(skips); }

  /// Call regularly. Frees memory that only very large messages need.
  void freeSpareMemory();

 private:
  ros::Subscriber subscribe(ros::NodeHandle& node, const TopicName& topic, bool is_static,
                            const Callback& on_message);

  // Shared, because roscpp may write into the memory for another subscriber of this process after
  // this object is destroyed.
  std::shared_ptr<TfMessageMemory> memory_ = std::make_shared<TfMessageMemory>();
  std::shared_ptr<TfMessageMemory> static_memory_ = std::make_shared<TfMessageMemory>();
  ros::Subscriber subscriber_;
  ros::Subscriber static_subscriber_;
};

}  // namespace link_bounds

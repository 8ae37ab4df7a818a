// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Subscribes, filters, and logs.
#include "node/tf/tf_receiver.h"

#include <ros/console.h>

#include <algorithm>
#include <iterator>

namespace link_bounds {
namespace {

constexpr std::uint32_t kQueue = 5000;  // messages

}  // namespace

TfReceiver::TfReceiver(ros::NodeHandle& node, const Callback& on_message)
    : subscriber_(subscribe(node, kTfTopic, false, on_message)),
      static_subscriber_(subscribe(node, kTfStaticTopic, true, on_message)) {}

/// Without tcpNoDelay the kernel delays small messages to send several at once.
ros::Subscriber TfReceiver::subscribe(ros::NodeHandle& node, const TopicName& topic, bool is_static,
                                      const Callback& on_message) {
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event&>(
      topic.name, kQueue,
      [on_message, is_static](const Event& event) { on_message(event, is_static); },
      [&memory = is_static ? static_memory_ : memory_] { return memory.lend(); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return node.subscribe(options);
}

void TfReceiver::add(const Event& event, bool is_static, const ClockWatch& clock, ros::Time now,
                     TransformBuffer& tf) {
  const auto is_late = [&](const TransformView& transform) {
    return clock.isFromBeforeJump(transform.stamp, now);
  };
  const auto& transforms = event.getConstMessage()->transforms;
  if (is_static || std::none_of(transforms.begin(), transforms.end(), is_late)) {
    return addAll(transforms, is_static, now, event, tf);
  }
  std::vector<TransformView> kept;
  std::remove_copy_if(transforms.begin(), transforms.end(), std::back_inserter(kept), is_late);
  tf.countDropped(transforms.size() - kept.size());
  addAll(kept, is_static, now, event, tf);
}

void TfReceiver::addAll(const std::vector<TransformView>& transforms, bool is_static, ros::Time now,
                        const Event& event, TransformBuffer& tf) {
  for (const Refusal& refusal : tf.add(transforms, is_static, now)) {
    const auto line = log_.line(std::string(transforms[refusal.index].child), refusal.reason,
                                event.getPublisherName(), ros::SteadyTime::now());
    if (line) ROS_WARN_STREAM(*line);
  }
}

void TfReceiver::freeSpareMemory() {
  memory_.giveBack();
  static_memory_.giveBack();
}

}  // namespace link_bounds

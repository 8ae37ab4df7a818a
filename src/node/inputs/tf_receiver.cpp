// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/inputs/tf_receiver.h"

namespace link_bounds {
namespace {

/// Max waiting messages of /tf_static. None may be dropped, because static transforms are sent
/// once.
constexpr std::uint32_t kStaticQueue = 5000;

}  // namespace

TfReceiver::TfReceiver(ros::NodeHandle& node, const Callback& on_message)
    : subscriber_(subscribe(node, kTfTopic, false, on_message)),
      static_subscriber_(subscribe(node, kTfStaticTopic, true, on_message)) {}

/// Without tcpNoDelay the kernel delays small messages to send several together.
ros::Subscriber TfReceiver::subscribe(ros::NodeHandle& node, const TopicName& topic, bool is_static,
                                      const Callback& on_message) {
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event&>(
      topic.name, is_static ? kStaticQueue : kQueue,
      [on_message, is_static](const Event& event) { on_message(event, is_static); },
      [memory = is_static ? static_memory_ : memory_] { return memory->lend(); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return node.subscribe(options);
}

void TfReceiver::freeSpareMemory() {
  memory_->giveBack();
  static_memory_->giveBack();
}

}  // namespace link_bounds

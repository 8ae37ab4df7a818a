// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A topic that costs nothing without subscribers.
#pragma once

#include <ros/node_handle.h>
#include <ros/single_subscriber_publisher.h>

#include <cstdint>
#include <functional>

#include "node/log/guarded.h"
#include "node/names/topics.h"

namespace link_bounds {

/// Who receives a message: all subscribers, or one that has just connected.
enum class Audience { kAll, kNewSubscriber };

/// Each new subscriber receives a message of its own when it connects.
template <class Message>
class OnDemand {
 public:
  /// Overwrites a message and reuses its memory; false if there is nothing to send.
  using Fill = std::function<bool(Message& message, Audience audience)>;

  OnDemand(ros::NodeHandle& private_node, const TopicName& topic, std::uint32_t queue, Guard guard,
           Fill fill)
      : guard_(std::move(guard)), fill_(std::move(fill)) {
    publisher_ = private_node.advertise<Message>(
        privateName(topic), queue, [this](const ros::SingleSubscriberPublisher& subscriber) {
          guard_([&] { sendTo(subscriber); });
        });
  }

  OnDemand(const OnDemand&) = delete;
  OnDemand& operator=(const OnDemand&) = delete;

  bool hasSubscribers() const { return publisher_.getNumSubscribers() > 0; }

  void freeSpareMemory() { message_ = Message(); }

  void publish() {
    if (hasSubscribers() && fill_(message_, Audience::kAll)) publisher_.publish(message_);
  }

 private:
  void sendTo(const ros::SingleSubscriberPublisher& subscriber) {
    if (fill_(message_, Audience::kNewSubscriber)) subscriber.publish(message_);
  }

  Guard guard_;
  Fill fill_;
  Message message_;
  ros::Publisher publisher_;
};

}  // namespace link_bounds

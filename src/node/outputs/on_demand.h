// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A topic that costs nothing while nobody listens.
#pragma once

#include <ros/node_handle.h>
#include <ros/single_subscriber_publisher.h>

#include <functional>

#include "node/log/guarded.h"
#include "node/names/topics.h"

namespace link_bounds {

/// For whom a message is made: all who listen, or one who has just come.
enum class Audience { kAll, kNewcomer };

/// Each new subscriber is sent a message of its own when it connects.
template <class Message>
class OnDemand {
 public:
  /// Overwrites a message, whose memory is kept; false if there is nothing to send.
  using Fill = std::function<bool(Message& message, Audience audience)>;

  OnDemand(ros::NodeHandle& private_node, const TopicName& topic, std::uint32_t queue, Guard guard,
           Fill fill)
      : guard_(std::move(guard)), fill_(std::move(fill)) {
    publisher_ = private_node.advertise<Message>(
        privateName(topic), queue, [this](const ros::SingleSubscriberPublisher& subscriber) {
          guard_([&] { welcome(subscriber); });
        });
  }

  bool isHeard() const { return publisher_.getNumSubscribers() > 0; }

  void forgetMessage() { message_ = Message(); }

  void publish() {
    if (isHeard() && fill_(message_, Audience::kAll)) publisher_.publish(message_);
  }

 private:
  void welcome(const ros::SingleSubscriberPublisher& subscriber) {
    if (fill_(message_, Audience::kNewcomer)) subscriber.publish(message_);
  }

  Guard guard_;
  Fill fill_;
  Message message_;
  ros::Publisher publisher_;
};

}  // namespace link_bounds
